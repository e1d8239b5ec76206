/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_Q_casadi__ ## ID
#endif

#include <math.h>

#ifndef casadi_real
#define casadi_real double
#endif

#ifndef casadi_int
#define casadi_int int
#endif

/* Add prefix to internal symbols */
#define casadi_f0 CASADI_PREFIX(f0)
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s3 CASADI_PREFIX(s3)
#define casadi_sq CASADI_PREFIX(sq)

/* Symbol visibility in DLLs */
#ifndef CASADI_SYMBOL_EXPORT
  #if defined(_WIN32) || defined(__WIN32__) || defined(__CYGWIN__)
    #if defined(STATIC_LINKED)
      #define CASADI_SYMBOL_EXPORT
    #else
      #define CASADI_SYMBOL_EXPORT __declspec(dllexport)
    #endif
  #elif defined(__GNUC__) && defined(GCC_HASCLASSVISIBILITY)
    #define CASADI_SYMBOL_EXPORT __attribute__ ((visibility ("default")))
  #else
    #define CASADI_SYMBOL_EXPORT
  #endif
#endif

static casadi_real casadi_sq(casadi_real x) { return x*x;}

/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void vd_Q_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vd_Q_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vd_Q_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {36, 1, 1};

/* vd_Q_casadi:(position[3],v_n[3],q_b2n_wxyz[4],f_b[3],dt,gyro_noise[3],accel_noise[3])->(out_Q[36]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72;
  a00=arg[2]? arg[2][1] : 0;
  a01=casadi_sq(a00);
  a02=arg[2]? arg[2][2] : 0;
  a03=casadi_sq(a02);
  a04=(a01-a03);
  a05=arg[2]? arg[2][0] : 0;
  a06=casadi_sq(a05);
  a07=arg[2]? arg[2][3] : 0;
  a08=casadi_sq(a07);
  a09=(a06-a08);
  a04=(a04+a09);
  a10=arg[6]? arg[6][0] : 0;
  a10=casadi_sq(a10);
  a11=(a04*a10);
  a12=(a11*a04);
  a05=(2.*a05);
  a13=(a05*a07);
  a14=(2.*a00);
  a15=(a14*a02);
  a16=(a13-a15);
  a17=arg[6]? arg[6][1] : 0;
  a17=casadi_sq(a17);
  a18=(a16*a17);
  a19=(a18*a16);
  a12=(a12+a19);
  a19=(a05*a02);
  a14=(a14*a07);
  a20=(a19+a14);
  a21=arg[6]? arg[6][2] : 0;
  a21=casadi_sq(a21);
  a22=(a20*a21);
  a23=(a22*a20);
  a12=(a12+a23);
  a23=arg[4]? arg[4][0] : 0;
  a24=(a12*a23);
  a25=arg[1]? arg[1][0] : 0;
  a26=arg[0]? arg[0][2] : 0;
  a27=6378137.;
  a28=1.;
  a29=6.6943799901413173e-03;
  a30=arg[0]? arg[0][1] : 0;
  a31=sin(a30);
  a32=casadi_sq(a31);
  a29=(a29*a32);
  a28=(a28-a29);
  a29=sqrt(a28);
  a27=(a27/a29);
  a27=(a26+a27);
  a25=(a25/a27);
  a30=cos(a30);
  a27=(a31/a30);
  a27=(a25*a27);
  a32=1.4584230000000000e-04;
  a33=(a32*a31);
  a33=(a27+a33);
  a15=(a15+a13);
  a34=(a15*a10);
  a35=(a34*a04);
  a36=(a03-a01);
  a36=(a36+a09);
  a09=(a36*a17);
  a37=(a09*a16);
  a35=(a35-a37);
  a05=(a05*a00);
  a37=(a02*a07);
  a37=(2.*a37);
  a38=(a05-a37);
  a39=(a38*a21);
  a40=(a39*a20);
  a35=(a35-a40);
  a40=(a33*a35);
  a32=(a32*a30);
  a32=(a25+a32);
  a41=(a01+a03);
  a41=(a06-a41);
  a41=(a41+a08);
  a21=(a41*a21);
  a42=(a21*a20);
  a14=(a19-a14);
  a10=(a14*a10);
  a43=(a10*a04);
  a44=(a05+a37);
  a17=(a44*a17);
  a45=(a17*a16);
  a43=(a43+a45);
  a42=(a42-a43);
  a43=(a32*a42);
  a40=(a40-a43);
  a43=(2.*a40);
  a45=casadi_sq(a23);
  a46=2.;
  a46=(a45/a46);
  a47=(a43*a46);
  a24=(a24+a47);
  a47=(a34*a15);
  a48=(a09*a36);
  a47=(a47+a48);
  a48=(a39*a38);
  a47=(a47+a48);
  a48=(a33*a47);
  a49=(a17*a36);
  a50=(a10*a15);
  a49=(a49-a50);
  a50=(a21*a38);
  a49=(a49-a50);
  a50=(a32*a49);
  a48=(a48-a50);
  a50=(2.*a48);
  a51=(a50*a33);
  a09=(a09*a44);
  a34=(a34*a14);
  a09=(a09-a34);
  a39=(a39*a41);
  a09=(a09-a39);
  a39=(a33*a09);
  a10=(a10*a14);
  a17=(a17*a44);
  a10=(a10+a17);
  a21=(a21*a41);
  a10=(a10+a21);
  a21=(a32*a10);
  a39=(a39-a21);
  a21=(2.*a39);
  a17=(a21*a32);
  a51=(a51-a17);
  a17=arg[3]? arg[3][0] : 0;
  a34=(a00*a02);
  a34=(2.*a34);
  a52=(a13+a34);
  a52=(a17*a52);
  a53=arg[3]? arg[3][1] : 0;
  a54=(a06-a01);
  a55=(a03+a54);
  a55=(a55-a08);
  a55=(a53*a55);
  a52=(a52+a55);
  a55=arg[3]? arg[3][2] : 0;
  a37=(a37-a05);
  a37=(a55*a37);
  a52=(a52+a37);
  a37=arg[5]? arg[5][1] : 0;
  a37=casadi_sq(a37);
  a56=(a44*a37);
  a57=(a56*a36);
  a58=arg[5]? arg[5][0] : 0;
  a58=casadi_sq(a58);
  a59=(a14*a58);
  a60=(a59*a15);
  a57=(a57-a60);
  a60=arg[5]? arg[5][2] : 0;
  a60=casadi_sq(a60);
  a61=(a41*a60);
  a62=(a61*a38);
  a57=(a57-a62);
  a62=(a52*a57);
  a63=(a00*a07);
  a63=(2.*a63);
  a63=(a63-a19);
  a63=(a17*a63);
  a07=(2.*a07);
  a02=(a07*a02);
  a05=(a05+a02);
  a05=(a53*a05);
  a63=(a63+a05);
  a05=(a08-a03);
  a05=(a05+a54);
  a05=(a55*a05);
  a63=(a63+a05);
  a05=(a15*a58);
  a54=(a05*a15);
  a02=(a36*a37);
  a64=(a02*a36);
  a54=(a54+a64);
  a64=(a38*a60);
  a65=(a64*a38);
  a54=(a54+a65);
  a65=(a63*a54);
  a62=(a62-a65);
  a65=(2.*a62);
  a66=(a65*a63);
  a51=(a51-a66);
  a66=(a59*a14);
  a67=(a56*a44);
  a66=(a66+a67);
  a67=(a61*a41);
  a66=(a66+a67);
  a67=(a52*a66);
  a68=(a02*a44);
  a69=(a05*a14);
  a68=(a68-a69);
  a69=(a64*a41);
  a68=(a68-a69);
  a69=(a63*a68);
  a67=(a67-a69);
  a69=(2.*a67);
  a70=(a69*a52);
  a51=(a51+a70);
  a70=(a33*a12);
  a71=arg[1]? arg[1][1] : 0;
  a72=6.3354393272928204e+06;
  a28=(a28*a29);
  a72=(a72/a28);
  a26=(a26+a72);
  a71=(a71/a26);
  a26=(a71*a42);
  a70=(a70+a26);
  a26=(a33*a70);
  a12=(a32*a12);
  a72=(a71*a35);
  a12=(a12+a72);
  a72=(a32*a12);
  a26=(a26+a72);
  a26=(2.*a26);
  a51=(a51-a26);
  a45=(a45*a23);
  a26=6.;
  a45=(a45/a26);
  a51=(a51*a45);
  a24=(a24+a51);
  if (res[0]!=0) res[0][0]=a24;
  a24=(a11*a15);
  a51=(a18*a36);
  a24=(a24-a51);
  a51=(a22*a38);
  a24=(a24-a51);
  a51=(a24*a23);
  a26=(a48-a70);
  a26=(a26*a46);
  a51=(a51+a26);
  a61=(a61*a20);
  a59=(a59*a04);
  a56=(a56*a16);
  a59=(a59+a56);
  a61=(a61-a59);
  a59=(a52*a61);
  a05=(a05*a04);
  a02=(a02*a16);
  a05=(a05-a02);
  a64=(a64*a20);
  a05=(a05-a64);
  a64=(a63*a05);
  a59=(a59-a64);
  a64=(2.*a59);
  a02=(a64*a63);
  a56=(a43*a33);
  a21=(a21*a71);
  a56=(a56+a21);
  a02=(a02-a56);
  a06=(a06-a03);
  a06=(a06+a01);
  a06=(a06-a08);
  a17=(a17*a06);
  a34=(a34-a13);
  a53=(a53*a34);
  a17=(a17+a53);
  a07=(a07*a00);
  a19=(a19+a07);
  a55=(a55*a19);
  a17=(a17+a55);
  a55=(a69*a17);
  a02=(a02-a55);
  a55=(a33*a24);
  a19=(a71*a49);
  a55=(a55+a19);
  a19=(a33*a55);
  a24=(a32*a24);
  a07=(a71*a47);
  a24=(a24+a07);
  a07=(a32*a24);
  a19=(a19+a07);
  a07=(a33*a40);
  a00=(a71*a12);
  a07=(a07+a00);
  a00=(a19+a07);
  a02=(a02-a00);
  a02=(a02*a45);
  a51=(a51+a02);
  if (res[0]!=0) res[0][1]=a51;
  a22=(a22*a41);
  a11=(a11*a14);
  a18=(a18*a44);
  a11=(a11+a18);
  a22=(a22-a11);
  a11=(a22*a23);
  a18=(a39+a12);
  a18=(a18*a46);
  a11=(a11+a18);
  a40=(a32*a40);
  a18=(a71*a70);
  a40=(a40-a18);
  a18=(a33*a22);
  a51=(a71*a10);
  a18=(a18+a51);
  a51=(a33*a18);
  a22=(a32*a22);
  a02=(a71*a09);
  a22=(a22+a02);
  a02=(a32*a22);
  a51=(a51+a02);
  a40=(a40-a51);
  a43=(a43*a32);
  a50=(a50*a71);
  a43=(a43+a50);
  a50=(a64*a52);
  a43=(a43-a50);
  a50=(a65*a17);
  a43=(a43+a50);
  a43=(a40+a43);
  a43=(a43*a45);
  a11=(a11+a43);
  if (res[0]!=0) res[0][2]=a11;
  a11=(a59*a46);
  a58=(a04*a58);
  a04=(a58*a04);
  a37=(a16*a37);
  a16=(a37*a16);
  a04=(a04+a16);
  a60=(a20*a60);
  a20=(a60*a20);
  a04=(a04+a20);
  a20=(a63*a04);
  a16=(a17*a61);
  a20=(a20-a16);
  a16=(a33*a20);
  a43=(a17*a05);
  a50=(a52*a04);
  a43=(a43-a50);
  a50=(a32*a43);
  a16=(a16-a50);
  a50=7.2921149999999999e-05;
  a31=(a50*a31);
  a27=(a27+a31);
  a31=(a27*a04);
  a51=(a71*a61);
  a31=(a31+a51);
  a51=(a63*a31);
  a16=(a16+a51);
  a50=(a50*a30);
  a25=(a25+a50);
  a50=(a25*a04);
  a30=(a71*a05);
  a50=(a50+a30);
  a30=(a52*a50);
  a16=(a16+a30);
  a30=(a65*a27);
  a51=(a69*a25);
  a30=(a30-a51);
  a30=(a16+a30);
  a30=(a30*a45);
  a30=(a11+a30);
  if (res[0]!=0) res[0][3]=a30;
  a30=(a62*a46);
  a15=(a58*a15);
  a36=(a37*a36);
  a15=(a15-a36);
  a38=(a60*a38);
  a15=(a15-a38);
  a38=(a63*a15);
  a36=(a17*a57);
  a38=(a38-a36);
  a36=(a33*a38);
  a51=(a17*a54);
  a02=(a52*a15);
  a51=(a51-a02);
  a02=(a32*a51);
  a36=(a36-a02);
  a02=(a27*a15);
  a00=(a71*a57);
  a02=(a02+a00);
  a00=(a63*a02);
  a36=(a36+a00);
  a00=(a25*a15);
  a53=(a71*a54);
  a00=(a00+a53);
  a53=(a52*a00);
  a36=(a36+a53);
  a53=(a64*a27);
  a69=(a69*a71);
  a53=(a53+a69);
  a53=(a36-a53);
  a53=(a53*a45);
  a53=(a30+a53);
  if (res[0]!=0) res[0][4]=a53;
  a53=(a67*a46);
  a60=(a60*a41);
  a58=(a58*a14);
  a37=(a37*a44);
  a58=(a58+a37);
  a60=(a60-a58);
  a58=(a63*a60);
  a37=(a17*a66);
  a58=(a58-a37);
  a37=(a33*a58);
  a44=(a17*a68);
  a14=(a52*a60);
  a44=(a44-a14);
  a14=(a32*a44);
  a37=(a37-a14);
  a14=(a27*a60);
  a41=(a71*a66);
  a14=(a14+a41);
  a41=(a63*a14);
  a37=(a37+a41);
  a41=(a25*a60);
  a69=(a71*a68);
  a41=(a41+a69);
  a69=(a52*a41);
  a37=(a37+a69);
  a64=(a64*a25);
  a65=(a65*a71);
  a64=(a64+a65);
  a64=(a37+a64);
  a64=(a64*a45);
  a64=(a53+a64);
  if (res[0]!=0) res[0][5]=a64;
  a35=(a35*a23);
  a35=(a35+a26);
  a26=(-a55);
  a26=(2.*a26);
  a64=(a26*a33);
  a65=(-a18);
  a65=(2.*a65);
  a69=(a65*a32);
  a64=(a64-a69);
  a69=(2.*a38);
  a34=(a69*a63);
  a64=(a64-a34);
  a34=(2.*a58);
  a13=(a34*a52);
  a64=(a64+a13);
  a07=(a07+a19);
  a64=(a64-a07);
  a64=(a64*a45);
  a35=(a35+a64);
  if (res[0]!=0) res[0][6]=a35;
  a47=(a47*a23);
  a35=(2.*a55);
  a35=(a35*a46);
  a47=(a47-a35);
  a35=(2.*a20);
  a64=(a35*a63);
  a70=(-a70);
  a70=(2.*a70);
  a07=(a70*a33);
  a65=(a65*a71);
  a07=(a07+a65);
  a64=(a64-a07);
  a07=(a34*a17);
  a64=(a64-a07);
  a07=(a33*a48);
  a65=(a71*a24);
  a07=(a07+a65);
  a07=(2.*a07);
  a64=(a64-a07);
  a64=(a64*a45);
  a47=(a47+a64);
  if (res[0]!=0) res[0][7]=a47;
  a09=(a09*a23);
  a47=(a24-a18);
  a47=(a47*a46);
  a09=(a09+a47);
  a48=(a32*a48);
  a55=(a71*a55);
  a48=(a48-a55);
  a55=(a33*a39);
  a64=(a71*a22);
  a55=(a55+a64);
  a48=(a48-a55);
  a70=(a70*a32);
  a26=(a26*a71);
  a70=(a70+a26);
  a26=(a35*a52);
  a70=(a70-a26);
  a26=(a69*a17);
  a70=(a70+a26);
  a70=(a48+a70);
  a70=(a70*a45);
  a09=(a09+a70);
  if (res[0]!=0) res[0][8]=a09;
  a09=(a20*a46);
  a70=(a27*a05);
  a26=(a25*a61);
  a70=(a70-a26);
  a26=(a63*a70);
  a55=(a33*a59);
  a64=(a71*a43);
  a55=(a55+a64);
  a26=(a26-a55);
  a55=(a17*a50);
  a26=(a26-a55);
  a55=(a69*a27);
  a64=(a34*a25);
  a55=(a55-a64);
  a55=(a26+a55);
  a55=(a55*a45);
  a55=(a09+a55);
  if (res[0]!=0) res[0][9]=a55;
  a55=(a38*a46);
  a64=(a27*a54);
  a07=(a25*a57);
  a64=(a64-a07);
  a07=(a63*a64);
  a65=(a33*a62);
  a19=(a71*a51);
  a65=(a65+a19);
  a07=(a07-a65);
  a65=(a17*a00);
  a07=(a07-a65);
  a65=(a35*a27);
  a34=(a34*a71);
  a65=(a65+a34);
  a65=(a07-a65);
  a65=(a65*a45);
  a65=(a55+a65);
  if (res[0]!=0) res[0][10]=a65;
  a65=(a58*a46);
  a34=(a27*a68);
  a19=(a25*a66);
  a34=(a34-a19);
  a19=(a63*a34);
  a13=(a33*a67);
  a06=(a71*a44);
  a13=(a13+a06);
  a19=(a19-a13);
  a13=(a17*a41);
  a19=(a19-a13);
  a35=(a35*a25);
  a69=(a69*a71);
  a35=(a35+a69);
  a35=(a19+a35);
  a35=(a35*a45);
  a35=(a65+a35);
  if (res[0]!=0) res[0][11]=a35;
  a42=(a42*a23);
  a35=(a12+a39);
  a35=(a35*a46);
  a42=(a42+a35);
  a24=(2.*a24);
  a35=(a24*a33);
  a22=(2.*a22);
  a69=(a22*a32);
  a35=(a35-a69);
  a69=(2.*a51);
  a13=(a69*a63);
  a35=(a35-a13);
  a13=(2.*a44);
  a06=(a13*a52);
  a35=(a35+a06);
  a40=(a40+a35);
  a40=(a40*a45);
  a42=(a42+a40);
  if (res[0]!=0) res[0][12]=a42;
  a49=(a49*a23);
  a49=(a49+a47);
  a47=(2.*a43);
  a42=(a47*a63);
  a12=(2.*a12);
  a33=(a12*a33);
  a40=(a22*a71);
  a33=(a33+a40);
  a42=(a42-a33);
  a33=(a13*a17);
  a42=(a42-a33);
  a48=(a48+a42);
  a48=(a48*a45);
  a49=(a49+a48);
  if (res[0]!=0) res[0][13]=a49;
  a10=(a10*a23);
  a22=(a22*a46);
  a10=(a10+a22);
  a39=(a32*a39);
  a18=(a71*a18);
  a39=(a39-a18);
  a39=(2.*a39);
  a12=(a12*a32);
  a24=(a24*a71);
  a12=(a12+a24);
  a24=(a47*a52);
  a12=(a12-a24);
  a24=(a69*a17);
  a12=(a12+a24);
  a39=(a39+a12);
  a39=(a39*a45);
  a10=(a10+a39);
  if (res[0]!=0) res[0][14]=a10;
  a43=(a43*a46);
  a59=(a32*a59);
  a20=(a71*a20);
  a59=(a59+a20);
  a20=(a52*a70);
  a59=(a59-a20);
  a20=(a17*a31);
  a59=(a59-a20);
  a20=(a69*a27);
  a10=(a13*a25);
  a20=(a20-a10);
  a20=(a59+a20);
  a20=(a20*a45);
  a20=(a43+a20);
  if (res[0]!=0) res[0][15]=a20;
  a51=(a51*a46);
  a62=(a32*a62);
  a38=(a71*a38);
  a62=(a62+a38);
  a38=(a52*a64);
  a62=(a62-a38);
  a38=(a17*a02);
  a62=(a62-a38);
  a38=(a47*a27);
  a13=(a13*a71);
  a38=(a38+a13);
  a38=(a62-a38);
  a38=(a38*a45);
  a38=(a51+a38);
  if (res[0]!=0) res[0][16]=a38;
  a44=(a44*a46);
  a32=(a32*a67);
  a58=(a71*a58);
  a32=(a32+a58);
  a58=(a52*a34);
  a32=(a32-a58);
  a58=(a17*a14);
  a32=(a32-a58);
  a47=(a47*a25);
  a69=(a69*a71);
  a47=(a47+a69);
  a47=(a32+a47);
  a47=(a47*a45);
  a47=(a44+a47);
  if (res[0]!=0) res[0][17]=a47;
  a47=(2.*a34);
  a69=(a47*a52);
  a58=(2.*a64);
  a67=(a58*a63);
  a69=(a69-a67);
  a16=(a16+a69);
  a16=(a16*a45);
  a11=(a11+a16);
  if (res[0]!=0) res[0][18]=a11;
  a11=(2.*a70);
  a16=(a11*a63);
  a69=(a47*a17);
  a16=(a16-a69);
  a26=(a26+a16);
  a26=(a26*a45);
  a09=(a09+a26);
  if (res[0]!=0) res[0][19]=a09;
  a09=(a58*a17);
  a26=(a11*a52);
  a09=(a09-a26);
  a59=(a59+a09);
  a59=(a59*a45);
  a43=(a43+a59);
  if (res[0]!=0) res[0][20]=a43;
  a04=(a04*a23);
  a43=(a11*a46);
  a04=(a04+a43);
  a43=(a58*a27);
  a59=(a47*a25);
  a43=(a43-a59);
  a59=(a27*a31);
  a09=(a25*a50);
  a59=(a59+a09);
  a59=(2.*a59);
  a43=(a43-a59);
  a43=(a43*a45);
  a04=(a04+a43);
  if (res[0]!=0) res[0][21]=a04;
  a15=(a15*a23);
  a04=(a64-a31);
  a04=(a04*a46);
  a15=(a15+a04);
  a43=(a27*a02);
  a59=(a25*a00);
  a43=(a43+a59);
  a59=(a27*a70);
  a09=(a71*a50);
  a59=(a59+a09);
  a09=(a43+a59);
  a26=(a11*a27);
  a47=(a47*a71);
  a26=(a26+a47);
  a09=(a09+a26);
  a09=(a09*a45);
  a15=(a15-a09);
  if (res[0]!=0) res[0][22]=a15;
  a60=(a60*a23);
  a15=(a34+a50);
  a15=(a15*a46);
  a60=(a60+a15);
  a70=(a25*a70);
  a15=(a71*a31);
  a70=(a70-a15);
  a15=(a27*a14);
  a09=(a25*a41);
  a15=(a15+a09);
  a70=(a70-a15);
  a11=(a11*a25);
  a58=(a58*a71);
  a11=(a11+a58);
  a11=(a70+a11);
  a11=(a11*a45);
  a60=(a60+a11);
  if (res[0]!=0) res[0][23]=a60;
  a60=(-a14);
  a60=(2.*a60);
  a11=(a60*a52);
  a58=(-a02);
  a58=(2.*a58);
  a15=(a58*a63);
  a11=(a11-a15);
  a36=(a36+a11);
  a36=(a36*a45);
  a30=(a30+a36);
  if (res[0]!=0) res[0][24]=a30;
  a31=(-a31);
  a31=(2.*a31);
  a30=(a31*a63);
  a36=(a60*a17);
  a30=(a30-a36);
  a07=(a07+a30);
  a07=(a07*a45);
  a55=(a55+a07);
  if (res[0]!=0) res[0][25]=a55;
  a55=(a58*a17);
  a07=(a31*a52);
  a55=(a55-a07);
  a62=(a62+a55);
  a62=(a62*a45);
  a51=(a51+a62);
  if (res[0]!=0) res[0][26]=a51;
  a05=(a05*a23);
  a05=(a05+a04);
  a04=(a58*a27);
  a51=(a60*a25);
  a04=(a04-a51);
  a59=(a59+a43);
  a04=(a04-a59);
  a04=(a04*a45);
  a05=(a05+a04);
  if (res[0]!=0) res[0][27]=a05;
  a54=(a54*a23);
  a05=(2.*a02);
  a05=(a05*a46);
  a54=(a54-a05);
  a05=(a27*a64);
  a04=(a71*a00);
  a05=(a05+a04);
  a05=(2.*a05);
  a04=(a31*a27);
  a60=(a60*a71);
  a04=(a04+a60);
  a05=(a05+a04);
  a05=(a05*a45);
  a54=(a54-a05);
  if (res[0]!=0) res[0][28]=a54;
  a68=(a68*a23);
  a54=(a00-a14);
  a54=(a54*a46);
  a68=(a68+a54);
  a64=(a25*a64);
  a02=(a71*a02);
  a64=(a64-a02);
  a02=(a27*a34);
  a05=(a71*a41);
  a02=(a02+a05);
  a64=(a64-a02);
  a31=(a31*a25);
  a58=(a58*a71);
  a31=(a31+a58);
  a31=(a64+a31);
  a31=(a31*a45);
  a68=(a68+a31);
  if (res[0]!=0) res[0][29]=a68;
  a41=(2.*a41);
  a68=(a41*a52);
  a00=(2.*a00);
  a31=(a00*a63);
  a68=(a68-a31);
  a37=(a37+a68);
  a37=(a37*a45);
  a53=(a53+a37);
  if (res[0]!=0) res[0][30]=a53;
  a53=(2.*a50);
  a63=(a53*a63);
  a37=(a41*a17);
  a63=(a63-a37);
  a19=(a19+a63);
  a19=(a19*a45);
  a65=(a65+a19);
  if (res[0]!=0) res[0][31]=a65;
  a17=(a00*a17);
  a52=(a53*a52);
  a17=(a17-a52);
  a32=(a32+a17);
  a32=(a32*a45);
  a44=(a44+a32);
  if (res[0]!=0) res[0][32]=a44;
  a61=(a61*a23);
  a50=(a50+a34);
  a50=(a50*a46);
  a61=(a61+a50);
  a50=(a00*a27);
  a44=(a41*a25);
  a50=(a50-a44);
  a70=(a70+a50);
  a70=(a70*a45);
  a61=(a61+a70);
  if (res[0]!=0) res[0][33]=a61;
  a57=(a57*a23);
  a57=(a57+a54);
  a27=(a53*a27);
  a54=(a41*a71);
  a27=(a27+a54);
  a64=(a64-a27);
  a64=(a64*a45);
  a57=(a57+a64);
  if (res[0]!=0) res[0][34]=a57;
  a66=(a66*a23);
  a41=(a41*a46);
  a66=(a66+a41);
  a34=(a25*a34);
  a14=(a71*a14);
  a34=(a34-a14);
  a34=(2.*a34);
  a53=(a53*a25);
  a00=(a00*a71);
  a53=(a53+a00);
  a34=(a34+a53);
  a34=(a34*a45);
  a66=(a66+a34);
  if (res[0]!=0) res[0][35]=a66;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_Q_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vd_Q_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vd_Q_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vd_Q_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vd_Q_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vd_Q_casadi_n_in(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_int vd_Q_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vd_Q_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_Q_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "position";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "f_b";
    case 4: return "dt";
    case 5: return "gyro_noise";
    case 6: return "accel_noise";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_Q_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Q";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_Q_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s2;
    case 5: return casadi_s0;
    case 6: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_Q_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vd_Q_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_Q_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


