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
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67;
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
  a10=(a04+a09);
  a11=arg[6]? arg[6][0] : 0;
  a11=casadi_sq(a11);
  a12=(a10*a11);
  a12=(a12*a10);
  a05=(2.*a05);
  a13=(a05*a07);
  a14=(2.*a00);
  a15=(a14*a02);
  a16=(a13-a15);
  a17=arg[6]? arg[6][1] : 0;
  a17=casadi_sq(a17);
  a18=(a16*a17);
  a18=(a18*a16);
  a12=(a12+a18);
  a18=(a05*a02);
  a14=(a14*a07);
  a19=(a18+a14);
  a20=arg[6]? arg[6][2] : 0;
  a20=casadi_sq(a20);
  a21=(a19*a20);
  a21=(a21*a19);
  a12=(a12+a21);
  a21=arg[4]? arg[4][0] : 0;
  a22=(a12*a21);
  a23=arg[1]? arg[1][0] : 0;
  a24=arg[0]? arg[0][2] : 0;
  a25=6378137.;
  a26=1.;
  a27=6.6943799901413173e-03;
  a28=arg[0]? arg[0][1] : 0;
  a29=sin(a28);
  a30=casadi_sq(a29);
  a27=(a27*a30);
  a26=(a26-a27);
  a27=sqrt(a26);
  a25=(a25/a27);
  a25=(a24+a25);
  a23=(a23/a25);
  a28=cos(a28);
  a25=(a29/a28);
  a25=(a23*a25);
  a30=1.4584230000000000e-04;
  a31=(a30*a29);
  a31=(a25+a31);
  a15=(a15+a13);
  a13=(a15*a11);
  a32=(a13*a10);
  a09=(a09-a04);
  a04=(a09*a17);
  a33=(a04*a16);
  a32=(a32-a33);
  a05=(a05*a00);
  a02=(a02*a07);
  a02=(2.*a02);
  a07=(a05-a02);
  a00=(a07*a20);
  a33=(a00*a19);
  a32=(a32-a33);
  a33=(a31*a32);
  a30=(a30*a28);
  a30=(a23+a30);
  a01=(a01+a03);
  a06=(a06-a01);
  a06=(a06+a08);
  a20=(a06*a20);
  a08=(a20*a19);
  a18=(a18-a14);
  a11=(a18*a11);
  a14=(a11*a10);
  a05=(a05+a02);
  a17=(a05*a17);
  a02=(a17*a16);
  a14=(a14+a02);
  a08=(a08-a14);
  a14=(a30*a08);
  a02=(a33-a14);
  a01=(2.*a02);
  a03=casadi_sq(a21);
  a34=2.;
  a34=(a03/a34);
  a01=(a01*a34);
  a22=(a22+a01);
  a13=(a13*a15);
  a04=(a04*a09);
  a13=(a13+a04);
  a00=(a00*a07);
  a13=(a13+a00);
  a00=(a31*a13);
  a04=(a17*a09);
  a01=(a11*a15);
  a04=(a04-a01);
  a01=(a20*a07);
  a04=(a04-a01);
  a01=(a30*a04);
  a00=(a00-a01);
  a01=(2.*a00);
  a01=(a01*a31);
  a35=(a31*a04);
  a11=(a11*a18);
  a17=(a17*a05);
  a11=(a11+a17);
  a20=(a20*a06);
  a11=(a11+a20);
  a20=(a30*a11);
  a35=(a35-a20);
  a20=(2.*a35);
  a20=(a20*a30);
  a01=(a01-a20);
  a20=arg[3]? arg[3][0] : 0;
  a17=(a20*a15);
  a36=arg[3]? arg[3][1] : 0;
  a37=(a36*a09);
  a17=(a17+a37);
  a37=arg[3]? arg[3][2] : 0;
  a38=(a37*a07);
  a17=(a17-a38);
  a38=arg[5]? arg[5][1] : 0;
  a38=casadi_sq(a38);
  a39=(a05*a38);
  a40=(a39*a09);
  a41=arg[5]? arg[5][0] : 0;
  a41=casadi_sq(a41);
  a42=(a18*a41);
  a43=(a42*a15);
  a40=(a40-a43);
  a43=arg[5]? arg[5][2] : 0;
  a43=casadi_sq(a43);
  a44=(a06*a43);
  a45=(a44*a07);
  a40=(a40-a45);
  a45=(a17*a40);
  a46=(a36*a05);
  a47=(a20*a18);
  a46=(a46-a47);
  a47=(a37*a06);
  a46=(a46+a47);
  a47=(a15*a41);
  a15=(a47*a15);
  a48=(a09*a38);
  a09=(a48*a09);
  a15=(a15+a09);
  a09=(a07*a43);
  a07=(a09*a07);
  a15=(a15+a07);
  a07=(a46*a15);
  a45=(a45-a07);
  a07=(2.*a45);
  a07=(a07*a46);
  a01=(a01-a07);
  a18=(a42*a18);
  a05=(a39*a05);
  a18=(a18+a05);
  a06=(a44*a06);
  a18=(a18+a06);
  a06=(a17*a18);
  a05=(a46*a40);
  a06=(a06-a05);
  a05=(2.*a06);
  a05=(a05*a17);
  a01=(a01+a05);
  a05=(a31*a12);
  a07=arg[1]? arg[1][1] : 0;
  a49=6.3354393272928204e+06;
  a26=(a26*a27);
  a49=(a49/a26);
  a24=(a24+a49);
  a07=(a07/a24);
  a24=(a07*a08);
  a05=(a05+a24);
  a24=(a31*a05);
  a12=(a30*a12);
  a49=(a07*a32);
  a12=(a12+a49);
  a49=(a30*a12);
  a24=(a24+a49);
  a24=(2.*a24);
  a01=(a01-a24);
  a03=(a03*a21);
  a24=6.;
  a03=(a03/a24);
  a01=(a01*a03);
  a22=(a22+a01);
  if (res[0]!=0) res[0][0]=a22;
  a22=(a32*a21);
  a01=(a00-a05);
  a01=(a01*a34);
  a22=(a22+a01);
  a01=(a07*a04);
  a33=(a33+a01);
  a24=(-a33);
  a24=(2.*a24);
  a49=(a24*a31);
  a26=(a31*a08);
  a27=(a07*a11);
  a26=(a26+a27);
  a27=(-a26);
  a27=(2.*a27);
  a50=(a27*a30);
  a49=(a49-a50);
  a47=(a47*a10);
  a48=(a48*a16);
  a47=(a47-a48);
  a09=(a09*a19);
  a47=(a47-a09);
  a09=(a46*a47);
  a20=(a20*a10);
  a36=(a36*a16);
  a20=(a20-a36);
  a37=(a37*a19);
  a20=(a20+a37);
  a37=(a20*a40);
  a36=(a09-a37);
  a48=(2.*a36);
  a48=(a48*a46);
  a49=(a49-a48);
  a44=(a44*a19);
  a42=(a42*a10);
  a39=(a39*a16);
  a42=(a42+a39);
  a44=(a44-a42);
  a42=(a46*a44);
  a39=(a20*a18);
  a42=(a42-a39);
  a39=(2.*a42);
  a48=(a39*a17);
  a49=(a49+a48);
  a48=(a31*a02);
  a50=(a07*a12);
  a48=(a48+a50);
  a50=(a31*a33);
  a32=(a30*a32);
  a51=(a07*a13);
  a32=(a32+a51);
  a51=(a30*a32);
  a50=(a50+a51);
  a48=(a48+a50);
  a49=(a49-a48);
  a49=(a49*a03);
  a22=(a22+a49);
  if (res[0]!=0) res[0][1]=a22;
  a08=(a08*a21);
  a49=(a12+a35);
  a49=(a49*a34);
  a08=(a08+a49);
  a02=(a30*a02);
  a49=(a07*a05);
  a02=(a02-a49);
  a49=(a31*a26);
  a14=(a14+a01);
  a01=(a30*a14);
  a49=(a49+a01);
  a02=(a02-a49);
  a49=(2.*a32);
  a01=(a49*a31);
  a48=(2.*a14);
  a50=(a48*a30);
  a01=(a01-a50);
  a50=(a20*a15);
  a51=(a17*a47);
  a50=(a50-a51);
  a51=(2.*a50);
  a52=(a51*a46);
  a01=(a01-a52);
  a52=(a17*a44);
  a37=(a37-a52);
  a53=(2.*a37);
  a54=(a53*a17);
  a01=(a01+a54);
  a02=(a02+a01);
  a02=(a02*a03);
  a08=(a08+a02);
  if (res[0]!=0) res[0][2]=a08;
  a52=(a52-a09);
  a09=(a52*a34);
  a41=(a10*a41);
  a41=(a41*a10);
  a38=(a16*a38);
  a38=(a38*a16);
  a41=(a41+a38);
  a43=(a19*a43);
  a43=(a43*a19);
  a41=(a41+a43);
  a43=(a46*a41);
  a19=(a20*a44);
  a43=(a43-a19);
  a19=(a31*a43);
  a38=(a20*a47);
  a16=(a17*a41);
  a38=(a38-a16);
  a16=(a30*a38);
  a19=(a19-a16);
  a16=7.2921149999999999e-05;
  a29=(a16*a29);
  a25=(a25+a29);
  a29=(a25*a41);
  a10=(a07*a44);
  a29=(a29+a10);
  a10=(a46*a29);
  a19=(a19+a10);
  a16=(a16*a28);
  a23=(a23+a16);
  a16=(a23*a41);
  a28=(a07*a47);
  a16=(a16+a28);
  a28=(a17*a16);
  a19=(a19+a28);
  a28=(a25*a40);
  a10=(a23*a18);
  a28=(a28-a10);
  a10=(2.*a28);
  a02=(a10*a17);
  a01=(a25*a15);
  a54=(a23*a40);
  a01=(a01-a54);
  a54=(2.*a01);
  a55=(a54*a46);
  a02=(a02-a55);
  a19=(a19+a02);
  a19=(a19*a03);
  a09=(a09+a19);
  if (res[0]!=0) res[0][3]=a09;
  a19=(a45*a34);
  a02=(a31*a36);
  a55=(a30*a50);
  a02=(a02-a55);
  a55=(a25*a47);
  a56=(a07*a40);
  a57=(a55+a56);
  a58=(a46*a57);
  a02=(a02+a58);
  a58=(a23*a47);
  a59=(a07*a15);
  a58=(a58+a59);
  a59=(a17*a58);
  a02=(a02+a59);
  a59=(a25*a44);
  a60=(a07*a18);
  a59=(a59+a60);
  a60=(-a59);
  a60=(2.*a60);
  a61=(a60*a17);
  a62=(-a57);
  a62=(2.*a62);
  a63=(a62*a46);
  a61=(a61-a63);
  a02=(a02+a61);
  a02=(a02*a03);
  a19=(a19+a02);
  if (res[0]!=0) res[0][4]=a19;
  a02=(a06*a34);
  a61=(a31*a42);
  a63=(a30*a37);
  a61=(a61-a63);
  a63=(a46*a59);
  a61=(a61+a63);
  a63=(a23*a44);
  a56=(a63+a56);
  a64=(a17*a56);
  a61=(a61+a64);
  a64=(2.*a56);
  a65=(a64*a17);
  a66=(2.*a58);
  a67=(a66*a46);
  a65=(a65-a67);
  a61=(a61+a65);
  a61=(a61*a03);
  a02=(a02+a61);
  if (res[0]!=0) res[0][5]=a02;
  if (res[0]!=0) res[0][6]=a22;
  a13=(a13*a21);
  a24=(a24*a34);
  a13=(a13+a24);
  a24=(2.*a43);
  a24=(a24*a46);
  a05=(-a05);
  a05=(2.*a05);
  a05=(a05*a31);
  a27=(a27*a07);
  a05=(a05+a27);
  a24=(a24-a05);
  a39=(a39*a20);
  a24=(a24-a39);
  a39=(a31*a00);
  a05=(a07*a32);
  a39=(a39+a05);
  a39=(2.*a39);
  a24=(a24-a39);
  a24=(a24*a03);
  a13=(a13+a24);
  if (res[0]!=0) res[0][7]=a13;
  a04=(a04*a21);
  a32=(a32-a26);
  a32=(a32*a34);
  a04=(a04+a32);
  a00=(a30*a00);
  a33=(a07*a33);
  a00=(a00-a33);
  a33=(a31*a35);
  a14=(a07*a14);
  a33=(a33+a14);
  a00=(a00-a33);
  a33=(2.*a38);
  a14=(a33*a46);
  a12=(2.*a12);
  a32=(a12*a31);
  a13=(a48*a07);
  a32=(a32+a13);
  a14=(a14-a32);
  a53=(a53*a20);
  a14=(a14-a53);
  a00=(a00+a14);
  a00=(a00*a03);
  a04=(a04+a00);
  if (res[0]!=0) res[0][8]=a04;
  a00=(a43*a34);
  a55=(a55-a63);
  a63=(a46*a55);
  a14=(a31*a52);
  a53=(a07*a38);
  a14=(a14+a53);
  a63=(a63-a14);
  a14=(a20*a16);
  a63=(a63-a14);
  a14=(2.*a55);
  a53=(a14*a46);
  a32=(a10*a20);
  a53=(a53-a32);
  a63=(a63+a53);
  a63=(a63*a03);
  a00=(a00+a63);
  if (res[0]!=0) res[0][9]=a00;
  a63=(a36*a34);
  a53=(a46*a01);
  a32=(a31*a45);
  a13=(a07*a50);
  a32=(a32+a13);
  a53=(a53-a32);
  a32=(a20*a58);
  a53=(a53-a32);
  a32=(-a29);
  a32=(2.*a32);
  a13=(a32*a46);
  a24=(a60*a20);
  a13=(a13-a24);
  a53=(a53+a13);
  a53=(a53*a03);
  a63=(a63+a53);
  if (res[0]!=0) res[0][10]=a63;
  a53=(a42*a34);
  a13=(a46*a28);
  a31=(a31*a06);
  a24=(a07*a37);
  a31=(a31+a24);
  a13=(a13-a31);
  a31=(a20*a56);
  a13=(a13-a31);
  a31=(2.*a16);
  a46=(a31*a46);
  a24=(a64*a20);
  a46=(a46-a24);
  a13=(a13+a46);
  a13=(a13*a03);
  a53=(a53+a13);
  if (res[0]!=0) res[0][11]=a53;
  if (res[0]!=0) res[0][12]=a08;
  if (res[0]!=0) res[0][13]=a04;
  a11=(a11*a21);
  a48=(a48*a34);
  a11=(a11+a48);
  a35=(a30*a35);
  a26=(a07*a26);
  a35=(a35-a26);
  a35=(2.*a35);
  a12=(a12*a30);
  a49=(a49*a07);
  a12=(a12+a49);
  a33=(a33*a17);
  a12=(a12-a33);
  a51=(a51*a20);
  a12=(a12+a51);
  a35=(a35+a12);
  a35=(a35*a03);
  a11=(a11+a35);
  if (res[0]!=0) res[0][14]=a11;
  a38=(a38*a34);
  a52=(a30*a52);
  a43=(a07*a43);
  a52=(a52+a43);
  a43=(a17*a55);
  a52=(a52-a43);
  a43=(a20*a29);
  a52=(a52-a43);
  a43=(a54*a20);
  a11=(a14*a17);
  a43=(a43-a11);
  a52=(a52+a43);
  a52=(a52*a03);
  a38=(a38+a52);
  if (res[0]!=0) res[0][15]=a38;
  a50=(a50*a34);
  a45=(a30*a45);
  a36=(a07*a36);
  a45=(a45+a36);
  a36=(a17*a01);
  a45=(a45-a36);
  a36=(a20*a57);
  a45=(a45-a36);
  a36=(a62*a20);
  a52=(a32*a17);
  a36=(a36-a52);
  a45=(a45+a36);
  a45=(a45*a03);
  a50=(a50+a45);
  if (res[0]!=0) res[0][16]=a50;
  a37=(a37*a34);
  a30=(a30*a06);
  a42=(a07*a42);
  a30=(a30+a42);
  a42=(a17*a28);
  a30=(a30-a42);
  a42=(a20*a59);
  a30=(a30-a42);
  a20=(a66*a20);
  a17=(a31*a17);
  a20=(a20-a17);
  a30=(a30+a20);
  a30=(a30*a03);
  a37=(a37+a30);
  if (res[0]!=0) res[0][17]=a37;
  if (res[0]!=0) res[0][18]=a09;
  if (res[0]!=0) res[0][19]=a00;
  if (res[0]!=0) res[0][20]=a38;
  a41=(a41*a21);
  a14=(a14*a34);
  a41=(a41+a14);
  a54=(a54*a25);
  a10=(a10*a23);
  a54=(a54-a10);
  a10=(a25*a29);
  a14=(a23*a16);
  a10=(a10+a14);
  a10=(2.*a10);
  a54=(a54-a10);
  a54=(a54*a03);
  a41=(a41+a54);
  if (res[0]!=0) res[0][21]=a41;
  a47=(a47*a21);
  a41=(a01-a29);
  a41=(a41*a34);
  a47=(a47+a41);
  a41=(a62*a25);
  a54=(a60*a23);
  a41=(a41-a54);
  a54=(a25*a55);
  a10=(a07*a16);
  a54=(a54+a10);
  a10=(a25*a57);
  a14=(a23*a58);
  a10=(a10+a14);
  a54=(a54+a10);
  a41=(a41-a54);
  a41=(a41*a03);
  a47=(a47+a41);
  if (res[0]!=0) res[0][22]=a47;
  a44=(a44*a21);
  a16=(a16+a28);
  a16=(a16*a34);
  a44=(a44+a16);
  a55=(a23*a55);
  a29=(a07*a29);
  a55=(a55-a29);
  a29=(a25*a59);
  a16=(a23*a56);
  a29=(a29+a16);
  a55=(a55-a29);
  a29=(a66*a25);
  a16=(a64*a23);
  a29=(a29-a16);
  a55=(a55+a29);
  a55=(a55*a03);
  a44=(a44+a55);
  if (res[0]!=0) res[0][23]=a44;
  if (res[0]!=0) res[0][24]=a19;
  if (res[0]!=0) res[0][25]=a63;
  if (res[0]!=0) res[0][26]=a50;
  if (res[0]!=0) res[0][27]=a47;
  a15=(a15*a21);
  a62=(a62*a34);
  a15=(a15+a62);
  a62=(a25*a01);
  a47=(a07*a58);
  a62=(a62+a47);
  a62=(2.*a62);
  a32=(a32*a25);
  a60=(a60*a07);
  a32=(a32+a60);
  a62=(a62+a32);
  a62=(a62*a03);
  a15=(a15-a62);
  if (res[0]!=0) res[0][28]=a15;
  a40=(a40*a21);
  a58=(a58-a59);
  a58=(a58*a34);
  a40=(a40+a58);
  a01=(a23*a01);
  a57=(a07*a57);
  a01=(a01-a57);
  a57=(a25*a28);
  a56=(a07*a56);
  a57=(a57+a56);
  a01=(a01-a57);
  a25=(a31*a25);
  a57=(a64*a07);
  a25=(a25+a57);
  a01=(a01-a25);
  a01=(a01*a03);
  a40=(a40+a01);
  if (res[0]!=0) res[0][29]=a40;
  if (res[0]!=0) res[0][30]=a02;
  if (res[0]!=0) res[0][31]=a53;
  if (res[0]!=0) res[0][32]=a37;
  if (res[0]!=0) res[0][33]=a44;
  if (res[0]!=0) res[0][34]=a40;
  a18=(a18*a21);
  a64=(a64*a34);
  a18=(a18+a64);
  a28=(a23*a28);
  a59=(a07*a59);
  a28=(a28-a59);
  a28=(2.*a28);
  a31=(a31*a23);
  a66=(a66*a07);
  a31=(a31+a66);
  a28=(a28+a31);
  a28=(a28*a03);
  a18=(a18+a28);
  if (res[0]!=0) res[0][35]=a18;
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


