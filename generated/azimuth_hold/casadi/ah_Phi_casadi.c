/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) ah_Phi_casadi__ ## ID
#endif

#include <math.h>
#include "../src/ah_math.h"
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
CASADI_SYMBOL_EXPORT void ah_Phi_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int ah_Phi_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int ah_Phi_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {121, 1, 1};

/* ah_Phi_casadi:(lon_lat_height[3],v_n[3],q_b2n_wxyz[4],f_b[3],dt)->(out_Phi[121]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65;
  a00=1.;
  if (res[0]!=0) res[0][0]=a00;
  a01=arg[0]? arg[0][2] : 0;
  a02=6378137.;
  a03=6.6943799901413173e-03;
  a04=arg[0]? arg[0][1] : 0;
  a05=sin(a04);
  a06=(a05*a05);
  a07=(a03*a06);
  a07=(a00-a07);
  a08=sqrt(a07);
  a09=(a00/a08);
  a02=(a02*a09);
  a10=(a01+a02);
  a11=(a00/a10);
  a04=cos(a04);
  a12=(a00/a04);
  a13=(a11*a12);
  a14=arg[1]? arg[1][0] : 0;
  a15=(a13*a14);
  a16=(a05*a04);
  a17=(a00/a07);
  a18=(a16*a17);
  a02=(a18*a02);
  a02=(a03*a02);
  a19=(a02*a11);
  a20=(a05*a12);
  a19=(a19-a20);
  a15=(a15*a19);
  a19=arg[4]? arg[4][0] : 0;
  a15=(a15*a19);
  a21=arg[1]? arg[1][1] : 0;
  a22=6.3354393272928204e+06;
  a07=(a07*a08);
  a22=(a22/a07);
  a07=(a01+a22);
  a08=(a07*a07);
  a08=(a21/a08);
  a23=2.0083139970423949e-02;
  a18=(a18*a22);
  a23=(a23*a18);
  a23=(a08*a23);
  a18=(a23*a19);
  a22=(a15*a18);
  a13=(a13*a19);
  a24=1.4584230000000000e-04;
  a25=(a24*a04);
  a26=(a14*a11);
  a27=(a04*a04);
  a27=(a26/a27);
  a10=(a10*a10);
  a10=(a14/a10);
  a02=(a10*a02);
  a28=(a20*a02);
  a27=(a27-a28);
  a28=(a25+a27);
  a29=(a28*a21);
  a24=(a24*a05);
  a30=(a02+a24);
  a31=arg[1]? arg[1][2] : 0;
  a32=(a30*a31);
  a29=(a29+a32);
  a29=(a29*a19);
  a32=(a13*a29);
  a22=(a22+a32);
  a32=5.0000000000000000e-01;
  a22=(a22*a32);
  a22=(a22-a15);
  if (res[0]!=0) res[0][1]=a22;
  a22=(a08*a19);
  a33=(a15*a22);
  a34=(a31*a10);
  a35=(a20*a10);
  a36=(a21*a35);
  a34=(a34-a36);
  a34=(a34*a19);
  a36=(a13*a34);
  a33=(a33+a36);
  a33=(a33*a32);
  a12=(a10*a12);
  a12=(a12*a19);
  a33=(a33-a12);
  if (res[0]!=0) res[0][2]=a33;
  a20=(a20*a11);
  a33=(a21*a20);
  a36=(a31*a11);
  a33=(a33-a36);
  a33=(a33*a19);
  a36=(a13*a33);
  a36=(a36*a32);
  a36=(a13+a36);
  if (res[0]!=0) res[0][3]=a36;
  a36=(a20*a14);
  a24=(a24+a36);
  a37=(a24*a19);
  a38=(a13*a37);
  a07=(a00/a07);
  a39=(a19*a07);
  a15=(a15*a39);
  a38=(a38-a15);
  a38=(a38*a32);
  if (res[0]!=0) res[0][4]=a38;
  a12=(a12*a19);
  a25=(a25+a26);
  a38=(a25*a19);
  a15=(a13*a38);
  a12=(a12+a15);
  a12=(a12*a32);
  a12=(-a12);
  if (res[0]!=0) res[0][5]=a12;
  a12=arg[3]? arg[3][0] : 0;
  a15=2.;
  a40=arg[2]? arg[2][1] : 0;
  a41=(a15*a40);
  a42=arg[2]? arg[2][3] : 0;
  a43=(a41*a42);
  a44=arg[2]? arg[2][0] : 0;
  a45=(a15*a44);
  a46=arg[2]? arg[2][2] : 0;
  a47=(a45*a46);
  a48=(a43-a47);
  a49=(a12*a48);
  a50=arg[3]? arg[3][1] : 0;
  a51=(a45*a40);
  a52=(a15*a42);
  a52=(a52*a46);
  a53=(a51+a52);
  a54=(a50*a53);
  a49=(a49+a54);
  a54=arg[3]? arg[3][2] : 0;
  a55=(a42*a42);
  a56=(a46*a46);
  a57=(a55-a56);
  a44=(a44*a44);
  a40=(a40*a40);
  a58=(a44-a40);
  a57=(a57+a58);
  a59=(a54*a57);
  a49=(a49+a59);
  a49=(a49*a19);
  a59=(a13*a49);
  a59=(a59*a32);
  a59=(-a59);
  if (res[0]!=0) res[0][6]=a59;
  a45=(a45*a42);
  a41=(a41*a46);
  a46=(a45+a41);
  a42=(a12*a46);
  a58=(a56+a58);
  a58=(a58-a55);
  a59=(a50*a58);
  a42=(a42+a59);
  a52=(a52-a51);
  a51=(a54*a52);
  a42=(a42+a51);
  a42=(a42*a19);
  a51=(a13*a42);
  a51=(a51*a32);
  if (res[0]!=0) res[0][7]=a51;
  a44=(a44-a56);
  a44=(a44+a40);
  a44=(a44-a55);
  a55=(a44*a19);
  a40=(a13*a55);
  a40=(a40*a32);
  a40=(-a40);
  if (res[0]!=0) res[0][8]=a40;
  a41=(a41-a45);
  a45=(a41*a19);
  a40=(a13*a45);
  a40=(a40*a32);
  a40=(-a40);
  if (res[0]!=0) res[0][9]=a40;
  a47=(a47+a43);
  a43=(a47*a19);
  a13=(a13*a43);
  a13=(a13*a32);
  a13=(-a13);
  if (res[0]!=0) res[0][10]=a13;
  a13=(a00-a18);
  a40=(a18*a18);
  a56=(a31*a23);
  a28=(a28*a14);
  a56=(a56-a28);
  a56=(a56*a19);
  a28=(a39*a56);
  a40=(a40+a28);
  a51=(a40*a32);
  a13=(a13+a51);
  if (res[0]!=0) res[0][11]=a13;
  a13=(a18*a22);
  a51=(a31*a08);
  a59=(a14*a35);
  a51=(a51+a59);
  a51=(a51*a19);
  a59=(a39*a51);
  a13=(a13+a59);
  a13=(a13*a32);
  a13=(a13-a22);
  if (res[0]!=0) res[0][12]=a13;
  a24=(a24+a36);
  a24=(a24*a19);
  a59=(a39*a24);
  a59=(a59*a32);
  a60=(-a59);
  if (res[0]!=0) res[0][13]=a60;
  a60=(a18*a39);
  a31=(a31*a07);
  a31=(a31*a19);
  a61=(a39*a31);
  a60=(a60+a61);
  a60=(a60*a32);
  a60=(a39-a60);
  if (res[0]!=0) res[0][14]=a60;
  a61=(a22*a19);
  a62=(-a61);
  if (res[0]!=0) res[0][15]=a62;
  a62=(a49*a39);
  a63=(a62*a32);
  if (res[0]!=0) res[0][16]=a63;
  a12=(a12*a44);
  a50=(a50*a41);
  a12=(a12+a50);
  a54=(a54*a47);
  a12=(a12+a54);
  a12=(a12*a19);
  a54=(a39*a12);
  a47=(a54*a32);
  a47=(-a47);
  if (res[0]!=0) res[0][17]=a47;
  a46=(a46*a19);
  a47=(a39*a46);
  a47=(a47*a32);
  a50=(-a47);
  if (res[0]!=0) res[0][18]=a50;
  a58=(a58*a19);
  a50=(a39*a58);
  a50=(a50*a32);
  a41=(-a50);
  if (res[0]!=0) res[0][19]=a41;
  a52=(a52*a19);
  a41=(a39*a52);
  a41=(a41*a32);
  a44=(-a41);
  if (res[0]!=0) res[0][20]=a44;
  a30=(a30*a14);
  a44=4.2053793008804680e-09;
  a63=(a16*a01);
  a64=9.7803253359000006e+00;
  a65=1.8894147482439335e-02;
  a65=(a65*a06);
  a65=(a64+a65);
  a65=(a65*a09);
  a63=(a63*a65);
  a44=(a44*a63);
  a16=(a16*a09);
  a09=3.8637053131731361e-03;
  a63=1.2932555768154467e-05;
  a63=(a63*a06);
  a03=(a03+a63);
  a03=(a03*a17);
  a09=(a09+a03);
  a16=(a16*a09);
  a09=7.3745167729419953e-14;
  a03=(a01*a01);
  a09=(a09*a03);
  a09=(a00+a09);
  a03=1.5678559428873979e-07;
  a17=2.0136051943431768e+00;
  a63=1.3411242658989924e-02;
  a63=(a63*a06);
  a17=(a17-a63);
  a17=(a01*a17);
  a03=(a03*a17);
  a09=(a09-a03);
  a16=(a16*a09);
  a64=(a64*a16);
  a44=(a44+a64);
  a30=(a30+a44);
  a23=(a21*a23);
  a30=(a30+a23);
  a30=(a30*a19);
  a23=(a19*a30);
  a23=(a23*a32);
  a23=(-a23);
  if (res[0]!=0) res[0][21]=a23;
  a14=(a14*a10);
  a23=1.4749033545883991e-13;
  a23=(a23*a01);
  a01=2.1026896504402340e-09;
  a01=(a01*a06);
  a23=(a23+a01);
  a01=3.1570428705798834e-07;
  a23=(a23-a01);
  a23=(a23*a65);
  a14=(a14+a23);
  a08=(a21*a08);
  a14=(a14+a08);
  a14=(a14*a19);
  a08=(a19*a14);
  a23=(a08*a32);
  a23=(a00-a23);
  if (res[0]!=0) res[0][22]=a23;
  a25=(a26+a25);
  a25=(a25*a19);
  a23=(a19*a25);
  a23=(a23*a32);
  if (res[0]!=0) res[0][23]=a23;
  a21=(a21*a07);
  a15=(a15*a21);
  a15=(a15*a19);
  a07=(a19*a15);
  a07=(a07*a32);
  if (res[0]!=0) res[0][24]=a07;
  if (res[0]!=0) res[0][25]=a19;
  a07=(a19*a42);
  a07=(a07*a32);
  a07=(-a07);
  if (res[0]!=0) res[0][26]=a07;
  a07=(a19*a12);
  a07=(a07*a32);
  if (res[0]!=0) res[0][27]=a07;
  a48=(a48*a19);
  a07=(a19*a48);
  a07=(a07*a32);
  a07=(-a07);
  if (res[0]!=0) res[0][28]=a07;
  a53=(a53*a19);
  a07=(a19*a53);
  a07=(a07*a32);
  a07=(-a07);
  if (res[0]!=0) res[0][29]=a07;
  a57=(a57*a19);
  a07=(a19*a57);
  a07=(a07*a32);
  a07=(-a07);
  if (res[0]!=0) res[0][30]=a07;
  a07=(a33*a29);
  a23=(a29*a18);
  a07=(a07-a23);
  a23=(a37*a56);
  a07=(a07+a23);
  a23=(a38*a30);
  a07=(a07+a23);
  a23=7.2921149999999999e-05;
  a05=(a23*a05);
  a02=(a02+a05);
  a02=(a02*a19);
  a65=(a49*a02);
  a07=(a07+a65);
  a23=(a23*a04);
  a27=(a23+a27);
  a27=(a27*a19);
  a04=(a42*a27);
  a07=(a07+a04);
  a07=(a07*a32);
  a07=(a29+a07);
  if (res[0]!=0) res[0][31]=a07;
  a07=(a33*a34);
  a04=(a29*a22);
  a07=(a07-a04);
  a04=(a37*a51);
  a07=(a07+a04);
  a04=(a38*a14);
  a07=(a07+a04);
  a10=(a10*a19);
  a04=(a49*a10);
  a07=(a07+a04);
  a35=(a35*a19);
  a04=(a42*a35);
  a07=(a07-a04);
  a07=(a07*a32);
  a07=(a34+a07);
  if (res[0]!=0) res[0][32]=a07;
  a07=(a00+a33);
  a04=(a33*a33);
  a65=(a37*a24);
  a04=(a04-a65);
  a01=(a38*a25);
  a04=(a04-a01);
  a11=(a19*a11);
  a06=(a49*a11);
  a04=(a04-a06);
  a20=(a20*a19);
  a44=(a42*a20);
  a04=(a04+a44);
  a04=(a04*a32);
  a07=(a07+a04);
  if (res[0]!=0) res[0][33]=a07;
  a07=(a29*a39);
  a04=(a33*a37);
  a07=(a07+a04);
  a04=(a37*a31);
  a07=(a07-a04);
  a04=(a38*a15);
  a07=(a07-a04);
  a07=(a07*a32);
  a07=(a37+a07);
  if (res[0]!=0) res[0][34]=a07;
  a07=(a25*a33);
  a21=(a21*a19);
  a04=(a37*a21);
  a04=(a07+a04);
  a04=(a04*a32);
  a04=(a04+a38);
  a04=(-a04);
  if (res[0]!=0) res[0][35]=a04;
  a04=(a37*a49);
  a64=(a38*a42);
  a04=(a04+a64);
  a36=(a36+a05);
  a36=(a36*a19);
  a05=(a49*a36);
  a04=(a04+a05);
  a26=(a26+a23);
  a26=(a26*a19);
  a23=(a42*a26);
  a04=(a04+a23);
  a04=(a04*a32);
  if (res[0]!=0) res[0][36]=a04;
  a04=(a21*a42);
  a64=(a33*a49);
  a16=(a38*a12);
  a64=(a64+a16);
  a64=(a04-a64);
  a64=(a64*a32);
  a64=(a64-a49);
  if (res[0]!=0) res[0][37]=a64;
  a64=(a33*a42);
  a16=(a37*a12);
  a64=(a64-a16);
  a16=(a49*a21);
  a64=(a64+a16);
  a64=(a64*a32);
  a64=(a42+a64);
  if (res[0]!=0) res[0][38]=a64;
  a64=(a42*a48);
  a16=(a49*a46);
  a64=(a64-a16);
  a64=(a64*a32);
  if (res[0]!=0) res[0][39]=a64;
  a64=(a42*a53);
  a16=(a49*a58);
  a64=(a64-a16);
  a64=(a64*a32);
  if (res[0]!=0) res[0][40]=a64;
  a64=(a42*a57);
  a16=(a49*a52);
  a64=(a64-a16);
  a64=(a64*a32);
  if (res[0]!=0) res[0][41]=a64;
  a64=(a38*a48);
  a16=(a33*a55);
  a09=(a37*a46);
  a16=(a16+a09);
  a64=(a64-a16);
  a64=(a64*a32);
  a64=(a64-a55);
  if (res[0]!=0) res[0][42]=a64;
  a64=(a38*a53);
  a16=(a33*a45);
  a09=(a37*a58);
  a16=(a16+a09);
  a64=(a64-a16);
  a64=(a64*a32);
  a64=(a64-a45);
  if (res[0]!=0) res[0][43]=a64;
  a64=(a38*a57);
  a16=(a33*a43);
  a09=(a37*a52);
  a16=(a16+a09);
  a64=(a64-a16);
  a64=(a64*a32);
  a64=(a64-a43);
  if (res[0]!=0) res[0][44]=a64;
  a64=(a21*a30);
  a16=(a56*a18);
  a09=(a24*a29);
  a16=(a16+a09);
  a09=(a31*a56);
  a16=(a16+a09);
  a64=(a64-a16);
  a16=(a49*a18);
  a64=(a64+a16);
  a16=(a12*a27);
  a64=(a64-a16);
  a64=(a64*a32);
  a64=(a56+a64);
  if (res[0]!=0) res[0][45]=a64;
  a64=(a21*a14);
  a16=(a56*a22);
  a09=(a24*a34);
  a16=(a16+a09);
  a09=(a31*a51);
  a16=(a16+a09);
  a64=(a64-a16);
  a16=(a49*a22);
  a64=(a64+a16);
  a16=(a12*a35);
  a64=(a64+a16);
  a64=(a64*a32);
  a64=(a51+a64);
  if (res[0]!=0) res[0][46]=a64;
  a64=(a31*a24);
  a16=(a24*a33);
  a64=(a64-a16);
  a16=(a21*a25);
  a64=(a64-a16);
  a16=(a12*a20);
  a64=(a64-a16);
  a64=(a64*a32);
  a64=(a64-a24);
  if (res[0]!=0) res[0][47]=a64;
  a64=(a00-a31);
  a28=(a28-a65);
  a65=(a31*a31);
  a28=(a28+a65);
  a65=(a21*a15);
  a28=(a28-a65);
  a28=(a28-a62);
  a28=(a28*a32);
  a64=(a64+a28);
  if (res[0]!=0) res[0][48]=a64;
  a64=(a51*a19);
  a28=(a25*a37);
  a64=(a64+a28);
  a16=(a31*a21);
  a64=(a64+a16);
  a64=(a64*a32);
  a64=(a64-a21);
  if (res[0]!=0) res[0][49]=a64;
  a64=(a31*a49);
  a04=(a04-a64);
  a64=(a12*a26);
  a04=(a04-a64);
  a04=(a04*a32);
  a04=(a49+a04);
  if (res[0]!=0) res[0][50]=a04;
  a04=(a24*a49);
  a64=(a21*a12);
  a04=(a04-a64);
  a04=(a04+a05);
  a04=(a04-a64);
  a04=(a04*a32);
  if (res[0]!=0) res[0][51]=a04;
  a04=(a31*a12);
  a05=(a24*a42);
  a04=(a04-a05);
  a05=(a49*a26);
  a04=(a04-a05);
  a04=(a04*a32);
  a04=(a04-a12);
  if (res[0]!=0) res[0][52]=a04;
  a04=(a49*a55);
  a05=(a12*a48);
  a04=(a04-a05);
  a04=(a04*a32);
  if (res[0]!=0) res[0][53]=a04;
  a04=(a49*a45);
  a05=(a12*a53);
  a04=(a04-a05);
  a04=(a04*a32);
  if (res[0]!=0) res[0][54]=a04;
  a04=(a49*a43);
  a05=(a12*a57);
  a04=(a04-a05);
  a04=(a04*a32);
  if (res[0]!=0) res[0][55]=a04;
  a04=(a24*a55);
  a05=(a31*a46);
  a04=(a04+a05);
  a05=(a21*a48);
  a04=(a04+a05);
  a04=(a04*a32);
  a04=(a04-a46);
  if (res[0]!=0) res[0][56]=a04;
  a04=(a24*a45);
  a16=(a31*a58);
  a04=(a04+a16);
  a16=(a21*a53);
  a04=(a04+a16);
  a04=(a04*a32);
  a04=(a04-a58);
  if (res[0]!=0) res[0][57]=a04;
  a04=(a24*a43);
  a09=(a31*a52);
  a04=(a04+a09);
  a09=(a21*a57);
  a04=(a04+a09);
  a04=(a04*a32);
  a04=(a04-a52);
  if (res[0]!=0) res[0][58]=a04;
  a04=(a30*a18);
  a03=(a25*a29);
  a04=(a04+a03);
  a56=(a15*a56);
  a04=(a04+a56);
  a56=(a42*a18);
  a04=(a04-a56);
  a56=(a12*a02);
  a04=(a04-a56);
  a04=(a04*a32);
  a04=(a04-a30);
  if (res[0]!=0) res[0][59]=a04;
  a04=(a30*a22);
  a56=(a25*a34);
  a04=(a04+a56);
  a51=(a15*a51);
  a04=(a04+a51);
  a51=(a42*a22);
  a04=(a04-a51);
  a51=(a12*a10);
  a04=(a04-a51);
  a04=(a04*a32);
  a04=(a04-a14);
  if (res[0]!=0) res[0][60]=a04;
  a24=(a15*a24);
  a07=(a07-a24);
  a24=(a12*a11);
  a07=(a07+a24);
  a07=(a07*a32);
  a07=(a25+a07);
  if (res[0]!=0) res[0][61]=a07;
  a30=(a30*a39);
  a28=(a28-a30);
  a31=(a15*a31);
  a28=(a28-a31);
  a31=(a42*a39);
  a28=(a28+a31);
  a28=(a28*a32);
  a28=(a15+a28);
  if (res[0]!=0) res[0][62]=a28;
  a08=(a08+a01);
  a08=(a08+a65);
  a08=(a08*a32);
  a08=(a00-a08);
  if (res[0]!=0) res[0][63]=a08;
  a08=(a15*a49);
  a65=(a12*a36);
  a08=(a08-a65);
  a08=(a08*a32);
  a08=(a08-a42);
  if (res[0]!=0) res[0][64]=a08;
  a08=(a25*a49);
  a65=(a42*a36);
  a08=(a08+a65);
  a08=(a08*a32);
  a08=(a12-a08);
  if (res[0]!=0) res[0][65]=a08;
  a25=(a25*a42);
  a15=(a15*a12);
  a25=(a25-a15);
  a25=(a25+a23);
  a25=(a25-a64);
  a25=(a25*a32);
  if (res[0]!=0) res[0][66]=a25;
  a25=(a12*a46);
  a64=(a42*a55);
  a25=(a25-a64);
  a25=(a25*a32);
  if (res[0]!=0) res[0][67]=a25;
  a25=(a12*a58);
  a64=(a42*a45);
  a25=(a25-a64);
  a25=(a25*a32);
  if (res[0]!=0) res[0][68]=a25;
  a12=(a12*a52);
  a25=(a42*a43);
  a12=(a12-a25);
  a12=(a12*a32);
  if (res[0]!=0) res[0][69]=a12;
  a12=(a26*a55);
  a25=(a21*a46);
  a12=(a12+a25);
  a25=(a48+a12);
  a25=(-a25);
  if (res[0]!=0) res[0][70]=a25;
  a25=(a26*a45);
  a64=(a21*a58);
  a25=(a25+a64);
  a64=(a53+a25);
  a64=(-a64);
  if (res[0]!=0) res[0][71]=a64;
  a64=(a26*a43);
  a23=(a21*a52);
  a64=(a64+a23);
  a23=(a57+a64);
  a23=(-a23);
  if (res[0]!=0) res[0][72]=a23;
  a23=(a36*a02);
  a40=(a40+a23);
  a23=(a26*a27);
  a40=(a40+a23);
  a40=(a40*a32);
  a40=(a18-a40);
  if (res[0]!=0) res[0][73]=a40;
  a13=(-a13);
  if (res[0]!=0) res[0][74]=a13;
  if (res[0]!=0) res[0][75]=a59;
  a60=(-a60);
  if (res[0]!=0) res[0][76]=a60;
  if (res[0]!=0) res[0][77]=a61;
  a61=(a36*a36);
  a62=(a62+a61);
  a60=(a26*a26);
  a62=(a62+a60);
  a62=(a62*a32);
  a62=(a00-a62);
  if (res[0]!=0) res[0][78]=a62;
  a62=(a21*a26);
  a62=(a62*a32);
  a13=(a36-a62);
  if (res[0]!=0) res[0][79]=a13;
  a13=(a21*a36);
  a54=(a54-a13);
  a54=(a54*a32);
  a54=(a54-a26);
  if (res[0]!=0) res[0][80]=a54;
  a54=(a36*a46);
  a40=(a26*a48);
  a54=(a54-a40);
  a54=(a54*a32);
  a54=(a55+a54);
  if (res[0]!=0) res[0][81]=a54;
  a54=(a36*a58);
  a40=(a26*a53);
  a54=(a54-a40);
  a54=(a54*a32);
  a54=(a45+a54);
  if (res[0]!=0) res[0][82]=a54;
  a54=(a36*a52);
  a40=(a26*a57);
  a54=(a54-a40);
  a54=(a54*a32);
  a54=(a43+a54);
  if (res[0]!=0) res[0][83]=a54;
  if (res[0]!=0) res[0][84]=a47;
  if (res[0]!=0) res[0][85]=a50;
  if (res[0]!=0) res[0][86]=a41;
  a41=(a02*a18);
  a50=(a11*a29);
  a41=(a41+a50);
  a50=(a36*a18);
  a41=(a41-a50);
  a50=(a21*a27);
  a41=(a41-a50);
  a41=(a41*a32);
  a41=(a41-a02);
  if (res[0]!=0) res[0][87]=a41;
  a41=(a02*a22);
  a50=(a11*a34);
  a41=(a41+a50);
  a50=(a36*a22);
  a41=(a41-a50);
  a50=(a21*a35);
  a41=(a41+a50);
  a41=(a41*a32);
  a41=(a41-a10);
  if (res[0]!=0) res[0][88]=a41;
  a41=(a11*a33);
  a50=(a21*a20);
  a41=(a41-a50);
  a41=(a41*a32);
  a41=(a11+a41);
  if (res[0]!=0) res[0][89]=a41;
  a41=(a11*a37);
  a50=(a02*a39);
  a41=(a41-a50);
  a41=(a41+a59);
  a41=(a41*a32);
  if (res[0]!=0) res[0][90]=a41;
  a19=(a10*a19);
  a38=(a11*a38);
  a19=(a19+a38);
  a19=(a19*a32);
  a19=(-a19);
  if (res[0]!=0) res[0][91]=a19;
  a62=(a36+a62);
  a62=(-a62);
  if (res[0]!=0) res[0][92]=a62;
  a06=(a06+a61);
  a61=(a21*a21);
  a06=(a06+a61);
  a06=(a06*a32);
  a06=(a00-a06);
  if (res[0]!=0) res[0][93]=a06;
  a42=(a11*a42);
  a06=(a26*a36);
  a42=(a42+a06);
  a42=(a42*a32);
  a42=(a42-a21);
  if (res[0]!=0) res[0][94]=a42;
  a42=(a36*a55);
  a42=(a42+a05);
  a42=(a42*a32);
  a46=(a46-a42);
  if (res[0]!=0) res[0][95]=a46;
  a46=(a36*a45);
  a46=(a46+a16);
  a46=(a46*a32);
  a58=(a58-a46);
  if (res[0]!=0) res[0][96]=a58;
  a58=(a36*a43);
  a58=(a58+a09);
  a58=(a58*a32);
  a52=(a52-a58);
  if (res[0]!=0) res[0][97]=a52;
  a52=(a11*a55);
  a52=(a52*a32);
  a52=(-a52);
  if (res[0]!=0) res[0][98]=a52;
  a52=(a11*a45);
  a52=(a52*a32);
  a52=(-a52);
  if (res[0]!=0) res[0][99]=a52;
  a52=(a11*a43);
  a52=(a52*a32);
  a52=(-a52);
  if (res[0]!=0) res[0][100]=a52;
  a29=(a20*a29);
  a52=(a27*a18);
  a29=(a29-a52);
  a18=(a26*a18);
  a29=(a29+a18);
  a02=(a21*a02);
  a29=(a29-a02);
  a29=(a29*a32);
  a29=(a27+a29);
  if (res[0]!=0) res[0][101]=a29;
  a34=(a20*a34);
  a29=(a27*a22);
  a34=(a34-a29);
  a22=(a26*a22);
  a34=(a34+a22);
  a10=(a21*a10);
  a34=(a34-a10);
  a34=(a34*a32);
  a34=(a34-a35);
  if (res[0]!=0) res[0][102]=a34;
  a33=(a20*a33);
  a34=(a21*a11);
  a33=(a33+a34);
  a33=(a33*a32);
  a33=(a20+a33);
  if (res[0]!=0) res[0][103]=a33;
  a27=(a27*a39);
  a37=(a20*a37);
  a27=(a27+a37);
  a39=(a26*a39);
  a27=(a27-a39);
  a27=(a27*a32);
  if (res[0]!=0) res[0][104]=a27;
  a36=(a36*a11);
  a36=(-a36);
  if (res[0]!=0) res[0][105]=a36;
  a13=(a13*a32);
  a26=(a26-a13);
  if (res[0]!=0) res[0][106]=a26;
  a49=(a20*a49);
  a06=(a06-a49);
  a06=(a06*a32);
  a21=(a21+a06);
  if (res[0]!=0) res[0][107]=a21;
  a44=(a44-a60);
  a44=(a44-a61);
  a44=(a44*a32);
  a44=(a00+a44);
  if (res[0]!=0) res[0][108]=a44;
  a12=(a12*a32);
  a48=(a48+a12);
  if (res[0]!=0) res[0][109]=a48;
  a25=(a25*a32);
  a53=(a53+a25);
  if (res[0]!=0) res[0][110]=a53;
  a64=(a64*a32);
  a57=(a57+a64);
  if (res[0]!=0) res[0][111]=a57;
  a55=(a20*a55);
  a55=(a55*a32);
  a55=(-a55);
  if (res[0]!=0) res[0][112]=a55;
  a45=(a20*a45);
  a45=(a45*a32);
  a45=(-a45);
  if (res[0]!=0) res[0][113]=a45;
  a20=(a20*a43);
  a20=(a20*a32);
  a20=(-a20);
  if (res[0]!=0) res[0][114]=a20;
  if (res[0]!=0) res[0][115]=a00;
  if (res[0]!=0) res[0][116]=a00;
  if (res[0]!=0) res[0][117]=a00;
  if (res[0]!=0) res[0][118]=a00;
  if (res[0]!=0) res[0][119]=a00;
  if (res[0]!=0) res[0][120]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int ah_Phi_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ah_Phi_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ah_Phi_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ah_Phi_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void ah_Phi_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ah_Phi_casadi_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int ah_Phi_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real ah_Phi_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ah_Phi_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "f_b";
    case 4: return "dt";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ah_Phi_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Phi";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ah_Phi_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ah_Phi_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ah_Phi_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ah_Phi_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


