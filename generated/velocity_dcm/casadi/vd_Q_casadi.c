/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_Q_casadi__ ## ID
#endif

#include <math.h>
#include "../src/vd_math.h"
#define cos BS_COS
#define sin BS_SIN

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

/* vd_Q_casadi:(lon_lat_height[3],v_n[3],q_b2n_wxyz[4],f_b[3],dt,gyro_noise[3],accel_noise[3])->(out_Q[36]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70;
  a00=arg[4]? arg[4][0] : 0;
  a01=2.5000000000000000e-01;
  a02=(a00*a01);
  a03=arg[2]? arg[2][1] : 0;
  a04=(a03*a03);
  a05=arg[2]? arg[2][2] : 0;
  a06=(a05*a05);
  a07=(a04-a06);
  a08=arg[2]? arg[2][0] : 0;
  a09=(a08*a08);
  a10=arg[2]? arg[2][3] : 0;
  a11=(a10*a10);
  a12=(a09-a11);
  a07=(a07+a12);
  a12=arg[6]? arg[6][0] : 0;
  a13=(a07*a12);
  a14=(a13*a13);
  a15=2.;
  a16=(a15*a03);
  a17=(a16*a05);
  a08=(a15*a08);
  a18=(a08*a10);
  a19=(a17-a18);
  a20=arg[6]? arg[6][1] : 0;
  a21=(a19*a20);
  a22=(a21*a21);
  a14=(a14+a22);
  a22=(a08*a05);
  a16=(a16*a10);
  a23=(a22+a16);
  a24=arg[6]? arg[6][2] : 0;
  a25=(a23*a24);
  a26=(a25*a25);
  a14=(a14+a26);
  a14=(a02*a14);
  a26=3.;
  a27=(a26*a00);
  a27=(a27*a01);
  a01=arg[3]? arg[3][0] : 0;
  a16=(a16-a22);
  a22=(a01*a16);
  a28=arg[3]? arg[3][1] : 0;
  a08=(a08*a03);
  a10=(a15*a10);
  a10=(a10*a05);
  a05=(a08+a10);
  a03=(a28*a05);
  a22=(a22+a03);
  a03=arg[3]? arg[3][2] : 0;
  a09=(a09-a04);
  a04=(a09+a11);
  a04=(a04-a06);
  a29=(a03*a04);
  a22=(a22+a29);
  a18=(a18+a17);
  a17=arg[5]? arg[5][0] : 0;
  a29=(a18*a17);
  a30=(a22*a29);
  a31=(a01*a18);
  a09=(a09-a11);
  a09=(a09+a06);
  a06=(a28*a09);
  a31=(a31+a06);
  a10=(a10-a08);
  a08=(a03*a10);
  a31=(a31+a08);
  a08=(a16*a17);
  a06=(a31*a08);
  a30=(a30-a06);
  a06=(a15*a00);
  a06=(a06/a26);
  a26=(a30*a06);
  a11=1.4584230000000000e-04;
  a32=arg[0]? arg[0][1] : 0;
  a33=sin(a32);
  a34=(a11*a33);
  a35=arg[1]? arg[1][0] : 0;
  a36=arg[0]? arg[0][2] : 0;
  a37=6378137.;
  a38=1.;
  a39=6.6943799901413173e-03;
  a40=(a33*a33);
  a39=(a39*a40);
  a38=(a38-a39);
  a39=sqrt(a38);
  a37=(a37/a39);
  a37=(a36+a37);
  a35=(a35/a37);
  a32=cos(a32);
  a37=(a33/a32);
  a37=(a35*a37);
  a34=(a34+a37);
  a01=(a01*a07);
  a28=(a28*a19);
  a01=(a01+a28);
  a03=(a03*a23);
  a01=(a01+a03);
  a03=(a01*a08);
  a07=(a07*a17);
  a17=(a22*a07);
  a03=(a03-a17);
  a17=(a34*a03);
  a11=(a11*a32);
  a11=(a11+a35);
  a28=(a31*a07);
  a40=(a01*a29);
  a28=(a28-a40);
  a40=(a11*a28);
  a17=(a17-a40);
  a40=7.2921149999999999e-05;
  a33=(a40*a33);
  a37=(a37+a33);
  a33=(a37*a07);
  a41=arg[1]? arg[1][1] : 0;
  a42=6.3354393272928204e+06;
  a38=(a38*a39);
  a42=(a42/a38);
  a36=(a36+a42);
  a41=(a41/a36);
  a36=(a41*a08);
  a33=(a33+a36);
  a36=(a22*a33);
  a17=(a17-a36);
  a40=(a40*a32);
  a35=(a35+a40);
  a40=(a35*a07);
  a32=(a41*a29);
  a40=(a40+a32);
  a32=(a31*a40);
  a17=(a17-a32);
  a00=(a00*a00);
  a15=(a15*a00);
  a00=9.;
  a15=(a15/a00);
  a17=(a17*a15);
  a26=(a26+a17);
  a17=(a26*a26);
  a00=arg[5]? arg[5][1] : 0;
  a32=(a09*a00);
  a36=(a22*a32);
  a42=(a05*a00);
  a38=(a31*a42);
  a36=(a36-a38);
  a38=(a36*a06);
  a39=(a01*a42);
  a19=(a19*a00);
  a00=(a22*a19);
  a39=(a39-a00);
  a00=(a34*a39);
  a43=(a31*a19);
  a44=(a01*a32);
  a43=(a43-a44);
  a44=(a11*a43);
  a00=(a00-a44);
  a44=(a37*a19);
  a45=(a41*a42);
  a44=(a44+a45);
  a45=(a22*a44);
  a00=(a00-a45);
  a45=(a35*a19);
  a46=(a41*a32);
  a45=(a45+a46);
  a46=(a31*a45);
  a00=(a00-a46);
  a00=(a00*a15);
  a38=(a38+a00);
  a00=(a38*a38);
  a17=(a17+a00);
  a00=arg[5]? arg[5][2] : 0;
  a46=(a10*a00);
  a47=(a22*a46);
  a48=(a04*a00);
  a49=(a31*a48);
  a47=(a47-a49);
  a49=(a47*a06);
  a50=(a01*a48);
  a23=(a23*a00);
  a00=(a22*a23);
  a50=(a50-a00);
  a00=(a34*a50);
  a51=(a31*a23);
  a52=(a01*a46);
  a51=(a51-a52);
  a52=(a11*a51);
  a00=(a00-a52);
  a52=(a37*a23);
  a53=(a41*a48);
  a52=(a52+a53);
  a53=(a22*a52);
  a00=(a00-a53);
  a53=(a35*a23);
  a54=(a41*a46);
  a53=(a53+a54);
  a54=(a31*a53);
  a00=(a00-a54);
  a00=(a00*a15);
  a49=(a49+a00);
  a00=(a49*a49);
  a17=(a17+a00);
  a18=(a18*a12);
  a00=(a34*a18);
  a16=(a16*a12);
  a12=(a11*a16);
  a00=(a00-a12);
  a12=(a00*a06);
  a12=(a13+a12);
  a54=(a34*a13);
  a55=(a41*a16);
  a54=(a54+a55);
  a55=(a34*a54);
  a56=(a11*a13);
  a57=(a41*a18);
  a56=(a56+a57);
  a57=(a11*a56);
  a55=(a55+a57);
  a55=(a55*a15);
  a12=(a12-a55);
  a55=(a12*a12);
  a17=(a17+a55);
  a09=(a09*a20);
  a55=(a34*a09);
  a05=(a05*a20);
  a20=(a11*a05);
  a55=(a55-a20);
  a20=(a55*a06);
  a20=(a21+a20);
  a57=(a34*a21);
  a58=(a41*a05);
  a57=(a57+a58);
  a58=(a34*a57);
  a59=(a11*a21);
  a60=(a41*a09);
  a59=(a59+a60);
  a60=(a11*a59);
  a58=(a58+a60);
  a58=(a58*a15);
  a20=(a20-a58);
  a58=(a20*a20);
  a17=(a17+a58);
  a10=(a10*a24);
  a58=(a34*a10);
  a04=(a04*a24);
  a24=(a11*a04);
  a58=(a58-a24);
  a24=(a58*a06);
  a24=(a25+a24);
  a60=(a34*a25);
  a61=(a41*a04);
  a60=(a60+a61);
  a61=(a34*a60);
  a62=(a11*a25);
  a63=(a41*a10);
  a62=(a62+a63);
  a63=(a11*a62);
  a61=(a61+a63);
  a61=(a61*a15);
  a24=(a24-a61);
  a61=(a24*a24);
  a17=(a17+a61);
  a17=(a27*a17);
  a14=(a14+a17);
  if (res[0]!=0) res[0][0]=a14;
  a14=(a18*a13);
  a17=(a09*a21);
  a14=(a14+a17);
  a17=(a10*a25);
  a14=(a14+a17);
  a14=(a02*a14);
  a17=(a03*a06);
  a61=(a35*a08);
  a63=(a37*a29);
  a61=(a61-a63);
  a63=(a22*a61);
  a64=(a34*a30);
  a65=(a41*a28);
  a64=(a64+a65);
  a63=(a63-a64);
  a64=(a01*a40);
  a63=(a63+a64);
  a63=(a63*a15);
  a17=(a17+a63);
  a63=(a17*a26);
  a64=(a39*a06);
  a65=(a35*a42);
  a66=(a37*a32);
  a65=(a65-a66);
  a66=(a22*a65);
  a67=(a34*a36);
  a68=(a41*a43);
  a67=(a67+a68);
  a66=(a66-a67);
  a67=(a01*a45);
  a66=(a66+a67);
  a66=(a66*a15);
  a64=(a64+a66);
  a66=(a64*a38);
  a63=(a63+a66);
  a66=(a50*a06);
  a67=(a35*a48);
  a68=(a37*a46);
  a67=(a67-a68);
  a22=(a22*a67);
  a68=(a34*a47);
  a69=(a41*a51);
  a68=(a68+a69);
  a22=(a22-a68);
  a68=(a01*a53);
  a22=(a22+a68);
  a22=(a22*a15);
  a66=(a66+a22);
  a22=(a66*a49);
  a63=(a63+a22);
  a22=(a54*a06);
  a22=(a18-a22);
  a68=(a34*a00);
  a69=(a41*a56);
  a68=(a68+a69);
  a68=(a68*a15);
  a22=(a22-a68);
  a68=(a22*a12);
  a63=(a63+a68);
  a68=(a57*a06);
  a68=(a09-a68);
  a69=(a34*a55);
  a70=(a41*a59);
  a69=(a69+a70);
  a69=(a69*a15);
  a68=(a68-a69);
  a69=(a68*a20);
  a63=(a63+a69);
  a69=(a60*a06);
  a69=(a10-a69);
  a34=(a34*a58);
  a70=(a41*a62);
  a34=(a34+a70);
  a34=(a34*a15);
  a69=(a69-a34);
  a34=(a69*a24);
  a63=(a63+a34);
  a63=(a27*a63);
  a14=(a14+a63);
  if (res[0]!=0) res[0][1]=a14;
  a13=(a16*a13);
  a21=(a05*a21);
  a13=(a13+a21);
  a25=(a04*a25);
  a13=(a13+a25);
  a13=(a02*a13);
  a28=(a28*a06);
  a30=(a11*a30);
  a03=(a41*a03);
  a30=(a30+a03);
  a03=(a31*a61);
  a30=(a30-a03);
  a03=(a01*a33);
  a30=(a30+a03);
  a30=(a30*a15);
  a28=(a28+a30);
  a30=(a28*a26);
  a43=(a43*a06);
  a36=(a11*a36);
  a39=(a41*a39);
  a36=(a36+a39);
  a39=(a31*a65);
  a36=(a36-a39);
  a39=(a01*a44);
  a36=(a36+a39);
  a36=(a36*a15);
  a43=(a43+a36);
  a36=(a43*a38);
  a30=(a30+a36);
  a51=(a51*a06);
  a47=(a11*a47);
  a50=(a41*a50);
  a47=(a47+a50);
  a31=(a31*a67);
  a47=(a47-a31);
  a01=(a01*a52);
  a47=(a47+a01);
  a47=(a47*a15);
  a51=(a51+a47);
  a47=(a51*a49);
  a30=(a30+a47);
  a56=(a56*a06);
  a56=(a16+a56);
  a00=(a11*a00);
  a54=(a41*a54);
  a00=(a00-a54);
  a00=(a00*a15);
  a56=(a56+a00);
  a12=(a56*a12);
  a30=(a30+a12);
  a59=(a59*a06);
  a59=(a05+a59);
  a55=(a11*a55);
  a57=(a41*a57);
  a55=(a55-a57);
  a55=(a55*a15);
  a59=(a59+a55);
  a20=(a59*a20);
  a30=(a30+a20);
  a62=(a62*a06);
  a62=(a04+a62);
  a11=(a11*a58);
  a60=(a41*a60);
  a11=(a11-a60);
  a11=(a11*a15);
  a62=(a62+a11);
  a24=(a62*a24);
  a30=(a30+a24);
  a30=(a27*a30);
  a13=(a13+a30);
  if (res[0]!=0) res[0][2]=a13;
  a30=(a61*a06);
  a30=(a30-a07);
  a24=(a37*a33);
  a11=(a35*a40);
  a24=(a24+a11);
  a24=(a24*a15);
  a30=(a30+a24);
  a24=(a30*a26);
  a11=(a65*a06);
  a11=(a11-a19);
  a60=(a37*a44);
  a58=(a35*a45);
  a60=(a60+a58);
  a60=(a60*a15);
  a11=(a11+a60);
  a60=(a11*a38);
  a24=(a24+a60);
  a60=(a67*a06);
  a60=(a60-a23);
  a58=(a37*a52);
  a20=(a35*a53);
  a58=(a58+a20);
  a58=(a58*a15);
  a60=(a60+a58);
  a58=(a60*a49);
  a24=(a24+a58);
  a24=(a27*a24);
  if (res[0]!=0) res[0][3]=a24;
  a58=(a33*a06);
  a58=(a58-a29);
  a20=(a41*a40);
  a55=(a37*a61);
  a20=(a20-a55);
  a20=(a20*a15);
  a58=(a58+a20);
  a20=(a58*a26);
  a55=(a44*a06);
  a55=(a55-a32);
  a57=(a41*a45);
  a12=(a37*a65);
  a57=(a57-a12);
  a57=(a57*a15);
  a55=(a55+a57);
  a57=(a55*a38);
  a20=(a20+a57);
  a57=(a52*a06);
  a57=(a57-a46);
  a12=(a41*a53);
  a37=(a37*a67);
  a12=(a12-a37);
  a12=(a12*a15);
  a57=(a57+a12);
  a12=(a57*a49);
  a20=(a20+a12);
  a20=(a27*a20);
  if (res[0]!=0) res[0][4]=a20;
  a61=(a35*a61);
  a33=(a41*a33);
  a61=(a61+a33);
  a61=(a61*a15);
  a40=(a40*a06);
  a40=(a08+a40);
  a61=(a61-a40);
  a26=(a61*a26);
  a65=(a35*a65);
  a44=(a41*a44);
  a65=(a65+a44);
  a65=(a65*a15);
  a45=(a45*a06);
  a45=(a42+a45);
  a65=(a65-a45);
  a38=(a65*a38);
  a26=(a26+a38);
  a35=(a35*a67);
  a41=(a41*a52);
  a35=(a35+a41);
  a35=(a35*a15);
  a53=(a53*a06);
  a53=(a48+a53);
  a35=(a35-a53);
  a49=(a35*a49);
  a26=(a26+a49);
  a26=(a27*a26);
  if (res[0]!=0) res[0][5]=a26;
  if (res[0]!=0) res[0][6]=a14;
  a14=(a18*a18);
  a49=(a09*a09);
  a14=(a14+a49);
  a49=(a10*a10);
  a14=(a14+a49);
  a14=(a02*a14);
  a49=(a17*a17);
  a53=(a64*a64);
  a49=(a49+a53);
  a53=(a66*a66);
  a49=(a49+a53);
  a53=(a22*a22);
  a49=(a49+a53);
  a53=(a68*a68);
  a49=(a49+a53);
  a53=(a69*a69);
  a49=(a49+a53);
  a49=(a27*a49);
  a14=(a14+a49);
  if (res[0]!=0) res[0][7]=a14;
  a18=(a16*a18);
  a09=(a05*a09);
  a18=(a18+a09);
  a10=(a04*a10);
  a18=(a18+a10);
  a18=(a02*a18);
  a10=(a28*a17);
  a09=(a43*a64);
  a10=(a10+a09);
  a09=(a51*a66);
  a10=(a10+a09);
  a22=(a56*a22);
  a10=(a10+a22);
  a68=(a59*a68);
  a10=(a10+a68);
  a69=(a62*a69);
  a10=(a10+a69);
  a10=(a27*a10);
  a18=(a18+a10);
  if (res[0]!=0) res[0][8]=a18;
  a10=(a30*a17);
  a69=(a11*a64);
  a10=(a10+a69);
  a69=(a60*a66);
  a10=(a10+a69);
  a10=(a27*a10);
  if (res[0]!=0) res[0][9]=a10;
  a69=(a58*a17);
  a68=(a55*a64);
  a69=(a69+a68);
  a68=(a57*a66);
  a69=(a69+a68);
  a69=(a27*a69);
  if (res[0]!=0) res[0][10]=a69;
  a17=(a61*a17);
  a64=(a65*a64);
  a17=(a17+a64);
  a66=(a35*a66);
  a17=(a17+a66);
  a17=(a27*a17);
  if (res[0]!=0) res[0][11]=a17;
  if (res[0]!=0) res[0][12]=a13;
  if (res[0]!=0) res[0][13]=a18;
  a16=(a16*a16);
  a05=(a05*a05);
  a16=(a16+a05);
  a04=(a04*a04);
  a16=(a16+a04);
  a16=(a02*a16);
  a04=(a28*a28);
  a05=(a43*a43);
  a04=(a04+a05);
  a05=(a51*a51);
  a04=(a04+a05);
  a56=(a56*a56);
  a04=(a04+a56);
  a59=(a59*a59);
  a04=(a04+a59);
  a62=(a62*a62);
  a04=(a04+a62);
  a04=(a27*a04);
  a16=(a16+a04);
  if (res[0]!=0) res[0][14]=a16;
  a16=(a30*a28);
  a04=(a11*a43);
  a16=(a16+a04);
  a04=(a60*a51);
  a16=(a16+a04);
  a16=(a27*a16);
  if (res[0]!=0) res[0][15]=a16;
  a04=(a58*a28);
  a62=(a55*a43);
  a04=(a04+a62);
  a62=(a57*a51);
  a04=(a04+a62);
  a04=(a27*a04);
  if (res[0]!=0) res[0][16]=a04;
  a28=(a61*a28);
  a43=(a65*a43);
  a28=(a28+a43);
  a51=(a35*a51);
  a28=(a28+a51);
  a28=(a27*a28);
  if (res[0]!=0) res[0][17]=a28;
  if (res[0]!=0) res[0][18]=a24;
  if (res[0]!=0) res[0][19]=a10;
  if (res[0]!=0) res[0][20]=a16;
  a16=(a07*a07);
  a10=(a19*a19);
  a16=(a16+a10);
  a10=(a23*a23);
  a16=(a16+a10);
  a16=(a02*a16);
  a10=(a30*a30);
  a24=(a11*a11);
  a10=(a10+a24);
  a24=(a60*a60);
  a10=(a10+a24);
  a10=(a27*a10);
  a16=(a16+a10);
  if (res[0]!=0) res[0][21]=a16;
  a16=(a29*a07);
  a10=(a32*a19);
  a16=(a16+a10);
  a10=(a46*a23);
  a16=(a16+a10);
  a16=(a02*a16);
  a10=(a58*a30);
  a24=(a55*a11);
  a10=(a10+a24);
  a24=(a57*a60);
  a10=(a10+a24);
  a10=(a27*a10);
  a16=(a16+a10);
  if (res[0]!=0) res[0][22]=a16;
  a07=(a08*a07);
  a19=(a42*a19);
  a07=(a07+a19);
  a23=(a48*a23);
  a07=(a07+a23);
  a07=(a02*a07);
  a30=(a61*a30);
  a11=(a65*a11);
  a30=(a30+a11);
  a60=(a35*a60);
  a30=(a30+a60);
  a30=(a27*a30);
  a07=(a07+a30);
  if (res[0]!=0) res[0][23]=a07;
  if (res[0]!=0) res[0][24]=a20;
  if (res[0]!=0) res[0][25]=a69;
  if (res[0]!=0) res[0][26]=a04;
  if (res[0]!=0) res[0][27]=a16;
  a16=(a29*a29);
  a04=(a32*a32);
  a16=(a16+a04);
  a04=(a46*a46);
  a16=(a16+a04);
  a16=(a02*a16);
  a04=(a58*a58);
  a69=(a55*a55);
  a04=(a04+a69);
  a69=(a57*a57);
  a04=(a04+a69);
  a04=(a27*a04);
  a16=(a16+a04);
  if (res[0]!=0) res[0][28]=a16;
  a29=(a08*a29);
  a32=(a42*a32);
  a29=(a29+a32);
  a46=(a48*a46);
  a29=(a29+a46);
  a29=(a02*a29);
  a58=(a61*a58);
  a55=(a65*a55);
  a58=(a58+a55);
  a57=(a35*a57);
  a58=(a58+a57);
  a58=(a27*a58);
  a29=(a29+a58);
  if (res[0]!=0) res[0][29]=a29;
  if (res[0]!=0) res[0][30]=a26;
  if (res[0]!=0) res[0][31]=a17;
  if (res[0]!=0) res[0][32]=a28;
  if (res[0]!=0) res[0][33]=a07;
  if (res[0]!=0) res[0][34]=a29;
  a08=(a08*a08);
  a42=(a42*a42);
  a08=(a08+a42);
  a48=(a48*a48);
  a08=(a08+a48);
  a02=(a02*a08);
  a61=(a61*a61);
  a65=(a65*a65);
  a61=(a61+a65);
  a35=(a35*a35);
  a61=(a61+a35);
  a27=(a27*a61);
  a02=(a02+a27);
  if (res[0]!=0) res[0][35]=a02;
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
    case 0: return "lon_lat_height";
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


