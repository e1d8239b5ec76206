/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_velocity_H_casadi__ ## ID
#endif

#include <math.h>
#include "../src/vas_math.h"
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
CASADI_SYMBOL_EXPORT void vas_velocity_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_velocity_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_velocity_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {6, 1, 1};
static const casadi_int casadi_s3[3] = {78, 1, 1};

/* vas_velocity_H_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],lever_b[3],a_n[3],flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_H[78]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67;
  a00=arg[5]? arg[5][0] : 0;
  a01=arg[2]? arg[2][1] : 0;
  a02=(2.*a01);
  a03=arg[2]? arg[2][3] : 0;
  a04=(a02*a03);
  a05=arg[2]? arg[2][0] : 0;
  a06=(2.*a05);
  a07=arg[2]? arg[2][2] : 0;
  a08=(a06*a07);
  a09=(a04-a08);
  a10=(a00*a09);
  a11=arg[5]? arg[5][1] : 0;
  a12=(a06*a01);
  a13=(2.*a03);
  a13=(a13*a07);
  a14=(a12+a13);
  a15=(a11*a14);
  a10=(a10+a15);
  a15=arg[5]? arg[5][2] : 0;
  a16=casadi_sq(a03);
  a17=casadi_sq(a07);
  a18=(a16-a17);
  a05=casadi_sq(a05);
  a01=casadi_sq(a01);
  a19=(a05-a01);
  a18=(a18+a19);
  a20=(a15*a18);
  a10=(a10+a20);
  a20=arg[1]? arg[1][1] : 0;
  a21=arg[0]? arg[0][2] : 0;
  a22=6378137.;
  a23=1.;
  a24=6.6943799901413173e-03;
  a25=arg[0]? arg[0][0] : 0;
  a26=sin(a25);
  a27=casadi_sq(a26);
  a24=(a24*a27);
  a24=(a23-a24);
  a27=sqrt(a24);
  a22=(a22/a27);
  a22=(a21+a22);
  a20=(a20/a22);
  a25=cos(a25);
  a22=(a26/a25);
  a22=(a20*a22);
  a28=7.2921149999999999e-05;
  a26=(a28*a26);
  a22=(a22+a26);
  a26=(a10*a22);
  a06=(a06*a03);
  a02=(a02*a07);
  a07=(a06+a02);
  a03=(a00*a07);
  a19=(a17+a19);
  a19=(a19-a16);
  a29=(a11*a19);
  a03=(a03+a29);
  a13=(a13-a12);
  a12=(a15*a13);
  a03=(a03+a12);
  a12=arg[1]? arg[1][0] : 0;
  a29=6.3354393272928204e+06;
  a24=(a24*a27);
  a29=(a29/a24);
  a21=(a21+a29);
  a12=(a12/a21);
  a21=(a03*a12);
  a29=(a26+a21);
  if (res[0]!=0) res[0][0]=a29;
  a29=arg[8]? arg[8][2] : 0;
  a29=(a23-a29);
  a24=arg[4]? arg[4][2] : 0;
  a27=(a29*a24);
  a30=arg[7]? arg[7][0] : 0;
  a31=arg[3]? arg[3][0] : 0;
  a32=(2.*a31);
  a33=arg[3]? arg[3][2] : 0;
  a34=(a32*a33);
  a35=arg[3]? arg[3][3] : 0;
  a36=(2.*a35);
  a37=arg[3]? arg[3][1] : 0;
  a36=(a36*a37);
  a38=(a34+a36);
  a39=(a30*a38);
  a27=(a27-a39);
  a39=arg[7]? arg[7][1] : 0;
  a40=(2.*a33);
  a40=(a40*a35);
  a41=(a32*a37);
  a42=(a40-a41);
  a43=(a39*a42);
  a27=(a27-a43);
  a43=arg[7]? arg[7][2] : 0;
  a44=casadi_sq(a35);
  a45=casadi_sq(a33);
  a46=(a44-a45);
  a31=casadi_sq(a31);
  a47=casadi_sq(a37);
  a48=(a31-a47);
  a46=(a46+a48);
  a49=(a43*a46);
  a27=(a27-a49);
  a49=arg[9]? arg[9][4] : 0;
  a50=arg[4]? arg[4][0] : 0;
  a51=(a49*a50);
  a27=(a27-a51);
  a51=arg[9]? arg[9][5] : 0;
  a52=arg[4]? arg[4][1] : 0;
  a53=(a51*a52);
  a27=(a27-a53);
  a53=(a27*a14);
  a54=arg[8]? arg[8][1] : 0;
  a54=(a23-a54);
  a55=(a54*a52);
  a37=(2.*a37);
  a37=(a37*a33);
  a32=(a32*a35);
  a35=(a37-a32);
  a33=(a30*a35);
  a55=(a55-a33);
  a48=(a45+a48);
  a48=(a48-a44);
  a33=(a39*a48);
  a55=(a55-a33);
  a41=(a41+a40);
  a40=(a43*a41);
  a55=(a55-a40);
  a40=arg[9]? arg[9][2] : 0;
  a33=(a40*a50);
  a55=(a55-a33);
  a33=arg[9]? arg[9][3] : 0;
  a56=(a33*a24);
  a55=(a55-a56);
  a56=(a55*a18);
  a53=(a53-a56);
  a56=(a53*a00);
  a57=arg[8]? arg[8][0] : 0;
  a57=(a23-a57);
  a58=(a57*a50);
  a31=(a31-a45);
  a31=(a31+a47);
  a31=(a31-a44);
  a44=(a30*a31);
  a58=(a58-a44);
  a32=(a32+a37);
  a37=(a39*a32);
  a58=(a58-a37);
  a36=(a36-a34);
  a34=(a43*a36);
  a58=(a58-a34);
  a34=arg[9]? arg[9][0] : 0;
  a37=(a34*a52);
  a58=(a58-a37);
  a37=arg[9]? arg[9][1] : 0;
  a44=(a37*a24);
  a58=(a58-a44);
  a44=(a58*a18);
  a47=(a27*a09);
  a44=(a44-a47);
  a47=(a44*a11);
  a56=(a56+a47);
  a47=(a55*a09);
  a45=(a58*a14);
  a47=(a47-a45);
  a45=(a47*a15);
  a56=(a56+a45);
  a05=(a05-a17);
  a05=(a05+a01);
  a05=(a05-a16);
  a16=(a00*a05);
  a02=(a02-a06);
  a06=(a11*a02);
  a16=(a16+a06);
  a08=(a08+a04);
  a04=(a15*a08);
  a16=(a16+a04);
  a04=(a16*a12);
  a04=(a56-a04);
  if (res[0]!=0) res[0][1]=a04;
  a04=(a16*a22);
  a06=(a27*a19);
  a01=(a55*a13);
  a06=(a06-a01);
  a01=(a06*a00);
  a17=(a58*a13);
  a45=(a27*a07);
  a17=(a17-a45);
  a45=(a17*a11);
  a01=(a01+a45);
  a45=(a55*a07);
  a59=(a58*a19);
  a45=(a45-a59);
  a59=(a45*a15);
  a01=(a01+a59);
  a04=(a04+a01);
  a04=(-a04);
  if (res[0]!=0) res[0][2]=a04;
  if (res[0]!=0) res[0][3]=a23;
  a04=(a11*a08);
  a59=(a15*a02);
  a04=(a04-a59);
  a59=(a57*a04);
  a60=(a15*a05);
  a61=(a00*a08);
  a60=(a60-a61);
  a61=(a60*a40);
  a59=(a59-a61);
  a61=(a00*a02);
  a62=(a11*a05);
  a61=(a61-a62);
  a62=(a61*a49);
  a59=(a59-a62);
  if (res[0]!=0) res[0][4]=a59;
  a59=(a60*a54);
  a62=(a61*a51);
  a59=(a59-a62);
  a62=(a04*a34);
  a59=(a59-a62);
  if (res[0]!=0) res[0][5]=a59;
  a59=(a61*a29);
  a62=(a60*a33);
  a59=(a59-a62);
  a62=(a04*a37);
  a59=(a59-a62);
  if (res[0]!=0) res[0][6]=a59;
  a59=(a60*a41);
  a62=(a61*a46);
  a59=(a59+a62);
  a62=(a04*a36);
  a59=(a59+a62);
  a62=(a59*a39);
  a63=(a60*a48);
  a64=(a61*a42);
  a63=(a63+a64);
  a64=(a04*a32);
  a63=(a63+a64);
  a64=(a63*a43);
  a62=(a62-a64);
  if (res[0]!=0) res[0][7]=a62;
  a62=(a60*a35);
  a64=(a61*a38);
  a62=(a62+a64);
  a64=(a04*a31);
  a62=(a62+a64);
  a64=(a62*a43);
  a65=(a59*a30);
  a64=(a64-a65);
  if (res[0]!=0) res[0][8]=a64;
  a64=(a63*a30);
  a65=(a62*a39);
  a64=(a64-a65);
  if (res[0]!=0) res[0][9]=a64;
  a64=arg[6]? arg[6][0] : 0;
  a64=(-a64);
  if (res[0]!=0) res[0][10]=a64;
  a64=(a07*a22);
  a65=(a09*a12);
  a66=(a27*a02);
  a67=(a55*a08);
  a66=(a66-a67);
  a65=(a65+a66);
  a64=(a64-a65);
  if (res[0]!=0) res[0][11]=a64;
  a64=(a19*a22);
  a65=(a14*a12);
  a67=(a58*a08);
  a27=(a27*a05);
  a67=(a67-a27);
  a65=(a65+a67);
  a64=(a64-a65);
  if (res[0]!=0) res[0][12]=a64;
  a64=(a13*a22);
  a65=(a18*a12);
  a55=(a55*a05);
  a58=(a58*a02);
  a55=(a55-a58);
  a65=(a65+a55);
  a64=(a64-a65);
  if (res[0]!=0) res[0][13]=a64;
  if (res[0]!=0) res[0][14]=a62;
  if (res[0]!=0) res[0][15]=a63;
  if (res[0]!=0) res[0][16]=a59;
  a59=(a04*a50);
  if (res[0]!=0) res[0][17]=a59;
  a59=(a60*a52);
  if (res[0]!=0) res[0][18]=a59;
  a59=(a61*a24);
  if (res[0]!=0) res[0][19]=a59;
  a59=(a04*a52);
  if (res[0]!=0) res[0][20]=a59;
  a04=(a04*a24);
  if (res[0]!=0) res[0][21]=a04;
  a04=(a60*a50);
  if (res[0]!=0) res[0][22]=a04;
  a60=(a60*a24);
  if (res[0]!=0) res[0][23]=a60;
  a60=(a61*a50);
  if (res[0]!=0) res[0][24]=a60;
  a61=(a61*a52);
  if (res[0]!=0) res[0][25]=a61;
  a28=(a28*a25);
  a20=(a20+a28);
  a28=(a03*a20);
  a28=(a28-a56);
  if (res[0]!=0) res[0][26]=a28;
  a16=(a16*a20);
  a26=(a26-a16);
  if (res[0]!=0) res[0][27]=a26;
  a66=(a66*a00);
  a67=(a67*a11);
  a66=(a66+a67);
  a55=(a55*a15);
  a66=(a66+a55);
  a03=(a03*a22);
  a03=(a66-a03);
  if (res[0]!=0) res[0][28]=a03;
  if (res[0]!=0) res[0][29]=a23;
  a03=(a11*a13);
  a55=(a15*a19);
  a03=(a03-a55);
  a55=(a03*a57);
  a67=(a15*a07);
  a26=(a00*a13);
  a67=(a67-a26);
  a26=(a67*a40);
  a55=(a55-a26);
  a26=(a00*a19);
  a28=(a11*a07);
  a26=(a26-a28);
  a28=(a26*a49);
  a55=(a55-a28);
  if (res[0]!=0) res[0][30]=a55;
  a55=(a67*a54);
  a28=(a26*a51);
  a55=(a55-a28);
  a28=(a03*a34);
  a55=(a55-a28);
  if (res[0]!=0) res[0][31]=a55;
  a55=(a26*a29);
  a28=(a67*a33);
  a55=(a55-a28);
  a28=(a03*a37);
  a55=(a55-a28);
  if (res[0]!=0) res[0][32]=a55;
  a55=(a67*a41);
  a28=(a26*a46);
  a55=(a55+a28);
  a28=(a03*a36);
  a55=(a55+a28);
  a28=(a55*a39);
  a56=(a67*a48);
  a25=(a26*a42);
  a56=(a56+a25);
  a25=(a03*a32);
  a56=(a56+a25);
  a25=(a56*a43);
  a28=(a28-a25);
  if (res[0]!=0) res[0][33]=a28;
  a28=(a67*a35);
  a25=(a26*a38);
  a28=(a28+a25);
  a25=(a03*a31);
  a28=(a28+a25);
  a25=(a28*a43);
  a61=(a55*a30);
  a25=(a25-a61);
  if (res[0]!=0) res[0][34]=a25;
  a25=(a56*a30);
  a61=(a28*a39);
  a25=(a25-a61);
  if (res[0]!=0) res[0][35]=a25;
  a25=arg[6]? arg[6][1] : 0;
  a25=(-a25);
  if (res[0]!=0) res[0][36]=a25;
  a25=(a05*a22);
  a25=(a25+a06);
  a06=(a09*a20);
  a25=(a25+a06);
  a25=(-a25);
  if (res[0]!=0) res[0][37]=a25;
  a25=(a02*a22);
  a25=(a25+a17);
  a17=(a14*a20);
  a25=(a25+a17);
  a25=(-a25);
  if (res[0]!=0) res[0][38]=a25;
  a22=(a08*a22);
  a22=(a22+a45);
  a45=(a18*a20);
  a22=(a22+a45);
  a22=(-a22);
  if (res[0]!=0) res[0][39]=a22;
  if (res[0]!=0) res[0][40]=a28;
  if (res[0]!=0) res[0][41]=a56;
  if (res[0]!=0) res[0][42]=a55;
  a55=(a03*a50);
  if (res[0]!=0) res[0][43]=a55;
  a55=(a67*a52);
  if (res[0]!=0) res[0][44]=a55;
  a55=(a26*a24);
  if (res[0]!=0) res[0][45]=a55;
  a55=(a03*a52);
  if (res[0]!=0) res[0][46]=a55;
  a03=(a03*a24);
  if (res[0]!=0) res[0][47]=a03;
  a03=(a67*a50);
  if (res[0]!=0) res[0][48]=a03;
  a67=(a67*a24);
  if (res[0]!=0) res[0][49]=a67;
  a67=(a26*a50);
  if (res[0]!=0) res[0][50]=a67;
  a26=(a26*a52);
  if (res[0]!=0) res[0][51]=a26;
  a26=(a10*a20);
  a26=(a26+a01);
  if (res[0]!=0) res[0][52]=a26;
  a10=(a10*a12);
  a10=(a10+a66);
  a10=(-a10);
  if (res[0]!=0) res[0][53]=a10;
  a21=(a21-a16);
  if (res[0]!=0) res[0][54]=a21;
  if (res[0]!=0) res[0][55]=a23;
  a23=(a11*a18);
  a21=(a15*a14);
  a23=(a23-a21);
  a57=(a23*a57);
  a15=(a15*a09);
  a18=(a00*a18);
  a15=(a15-a18);
  a40=(a15*a40);
  a57=(a57-a40);
  a00=(a00*a14);
  a11=(a11*a09);
  a00=(a00-a11);
  a49=(a00*a49);
  a57=(a57-a49);
  if (res[0]!=0) res[0][56]=a57;
  a54=(a15*a54);
  a51=(a00*a51);
  a54=(a54-a51);
  a34=(a23*a34);
  a54=(a54-a34);
  if (res[0]!=0) res[0][57]=a54;
  a29=(a00*a29);
  a33=(a15*a33);
  a29=(a29-a33);
  a37=(a23*a37);
  a29=(a29-a37);
  if (res[0]!=0) res[0][58]=a29;
  a41=(a15*a41);
  a46=(a00*a46);
  a41=(a41+a46);
  a36=(a23*a36);
  a41=(a41+a36);
  a36=(a41*a39);
  a48=(a15*a48);
  a42=(a00*a42);
  a48=(a48+a42);
  a32=(a23*a32);
  a48=(a48+a32);
  a32=(a48*a43);
  a36=(a36-a32);
  if (res[0]!=0) res[0][59]=a36;
  a35=(a15*a35);
  a38=(a00*a38);
  a35=(a35+a38);
  a31=(a23*a31);
  a35=(a35+a31);
  a43=(a35*a43);
  a31=(a41*a30);
  a43=(a43-a31);
  if (res[0]!=0) res[0][60]=a43;
  a30=(a48*a30);
  a39=(a35*a39);
  a30=(a30-a39);
  if (res[0]!=0) res[0][61]=a30;
  a30=arg[6]? arg[6][2] : 0;
  a30=(-a30);
  if (res[0]!=0) res[0][62]=a30;
  a07=(a07*a20);
  a07=(a07-a53);
  a05=(a05*a12);
  a07=(a07+a05);
  if (res[0]!=0) res[0][63]=a07;
  a19=(a19*a20);
  a19=(a19-a44);
  a02=(a02*a12);
  a19=(a19+a02);
  if (res[0]!=0) res[0][64]=a19;
  a13=(a13*a20);
  a13=(a13-a47);
  a08=(a08*a12);
  a13=(a13+a08);
  if (res[0]!=0) res[0][65]=a13;
  if (res[0]!=0) res[0][66]=a35;
  if (res[0]!=0) res[0][67]=a48;
  if (res[0]!=0) res[0][68]=a41;
  a41=(a23*a50);
  if (res[0]!=0) res[0][69]=a41;
  a41=(a15*a52);
  if (res[0]!=0) res[0][70]=a41;
  a41=(a00*a24);
  if (res[0]!=0) res[0][71]=a41;
  a41=(a23*a52);
  if (res[0]!=0) res[0][72]=a41;
  a23=(a23*a24);
  if (res[0]!=0) res[0][73]=a23;
  a23=(a15*a50);
  if (res[0]!=0) res[0][74]=a23;
  a15=(a15*a24);
  if (res[0]!=0) res[0][75]=a15;
  a50=(a00*a50);
  if (res[0]!=0) res[0][76]=a50;
  a00=(a00*a52);
  if (res[0]!=0) res[0][77]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_velocity_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_velocity_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_velocity_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_velocity_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_velocity_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_velocity_H_casadi_n_in(void) { return 10;}

CASADI_SYMBOL_EXPORT casadi_int vas_velocity_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_velocity_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_velocity_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "lever_b";
    case 6: return "a_n";
    case 7: return "flexure_rate";
    case 8: return "gyro_scale";
    case 9: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_velocity_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_velocity_H_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s0;
    case 7: return casadi_s0;
    case 8: return casadi_s0;
    case 9: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_velocity_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_velocity_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_velocity_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


