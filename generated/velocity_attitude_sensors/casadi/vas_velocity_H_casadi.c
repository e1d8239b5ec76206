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
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72;
  a00=7.2921149999999999e-05;
  a01=arg[0]? arg[0][0] : 0;
  a02=sin(a01);
  a03=(a00*a02);
  a04=arg[1]? arg[1][1] : 0;
  a05=arg[0]? arg[0][2] : 0;
  a06=6378137.;
  a07=1.;
  a08=6.6943799901413173e-03;
  a09=(a02*a02);
  a08=(a08*a09);
  a08=(a07-a08);
  a09=sqrt(a08);
  a06=(a06/a09);
  a06=(a05+a06);
  a04=(a04/a06);
  a01=cos(a01);
  a02=(a02/a01);
  a02=(a04*a02);
  a03=(a03+a02);
  a02=2.;
  a06=arg[2]? arg[2][0] : 0;
  a10=(a02*a06);
  a11=arg[2]? arg[2][1] : 0;
  a12=(a10*a11);
  a13=arg[2]? arg[2][3] : 0;
  a14=(a02*a13);
  a15=arg[2]? arg[2][2] : 0;
  a16=(a14*a15);
  a17=(a12+a16);
  a18=arg[5]? arg[5][1] : 0;
  a19=(a17*a18);
  a20=(a10*a15);
  a14=(a14*a11);
  a21=(a20-a14);
  a22=arg[5]? arg[5][0] : 0;
  a23=(a21*a22);
  a19=(a19-a23);
  a23=(a13*a13);
  a06=(a06*a06);
  a24=(a11*a11);
  a25=(a06-a24);
  a26=(a23+a25);
  a27=(a15*a15);
  a26=(a26-a27);
  a28=arg[5]? arg[5][2] : 0;
  a29=(a26*a28);
  a19=(a19+a29);
  a29=(a03*a19);
  a25=(a25-a23);
  a25=(a25+a27);
  a30=(a25*a18);
  a10=(a10*a13);
  a11=(a11*a15);
  a11=(a02*a11);
  a15=(a10+a11);
  a13=(a15*a22);
  a30=(a30+a13);
  a12=(a12-a16);
  a16=(a12*a28);
  a30=(a30-a16);
  a16=arg[1]? arg[1][0] : 0;
  a13=6.3354393272928204e+06;
  a08=(a08*a09);
  a13=(a13/a08);
  a05=(a05+a13);
  a05=(a07/a05);
  a13=(a16*a05);
  a08=(a30*a13);
  a09=(a29+a08);
  if (res[0]!=0) res[0][0]=a09;
  a09=arg[8]? arg[8][2] : 0;
  a09=(a07-a09);
  a31=arg[4]? arg[4][2] : 0;
  a32=(a09*a31);
  a33=arg[3]? arg[3][0] : 0;
  a34=(a02*a33);
  a35=arg[3]? arg[3][2] : 0;
  a36=(a34*a35);
  a37=arg[3]? arg[3][3] : 0;
  a38=(a02*a37);
  a39=arg[3]? arg[3][1] : 0;
  a38=(a38*a39);
  a40=(a36+a38);
  a41=arg[7]? arg[7][0] : 0;
  a42=(a40*a41);
  a32=(a32-a42);
  a42=(a35*a37);
  a42=(a02*a42);
  a43=(a34*a39);
  a44=(a42-a43);
  a45=arg[7]? arg[7][1] : 0;
  a46=(a44*a45);
  a32=(a32-a46);
  a46=(a37*a37);
  a47=(a35*a35);
  a48=(a46-a47);
  a33=(a33*a33);
  a49=(a39*a39);
  a50=(a33-a49);
  a48=(a48+a50);
  a51=arg[7]? arg[7][2] : 0;
  a52=(a48*a51);
  a32=(a32-a52);
  a52=arg[9]? arg[9][4] : 0;
  a53=arg[4]? arg[4][0] : 0;
  a54=(a52*a53);
  a32=(a32-a54);
  a54=arg[9]? arg[9][5] : 0;
  a55=arg[4]? arg[4][1] : 0;
  a56=(a54*a55);
  a32=(a32-a56);
  a56=(a17*a32);
  a57=arg[8]? arg[8][1] : 0;
  a57=(a07-a57);
  a58=(a57*a55);
  a39=(a39*a35);
  a02=(a02*a39);
  a34=(a34*a37);
  a37=(a02-a34);
  a39=(a37*a41);
  a58=(a58-a39);
  a43=(a43+a42);
  a42=(a43*a51);
  a58=(a58-a42);
  a50=(a47+a50);
  a50=(a50-a46);
  a42=(a50*a45);
  a58=(a58-a42);
  a42=arg[9]? arg[9][2] : 0;
  a39=(a42*a53);
  a58=(a58-a39);
  a39=arg[9]? arg[9][3] : 0;
  a35=(a39*a31);
  a58=(a58-a35);
  a35=(a26*a58);
  a59=(a56-a35);
  a59=(a22*a59);
  a60=(a21*a32);
  a61=arg[8]? arg[8][0] : 0;
  a61=(a07-a61);
  a62=(a61*a53);
  a34=(a34+a02);
  a02=(a34*a45);
  a62=(a62-a02);
  a38=(a38-a36);
  a36=(a38*a51);
  a62=(a62-a36);
  a33=(a33-a47);
  a33=(a33+a49);
  a33=(a33-a46);
  a46=(a33*a41);
  a62=(a62-a46);
  a46=arg[9]? arg[9][0] : 0;
  a49=(a46*a55);
  a62=(a62-a49);
  a49=arg[9]? arg[9][1] : 0;
  a47=(a49*a31);
  a62=(a62-a47);
  a47=(a26*a62);
  a60=(a60+a47);
  a47=(a60*a18);
  a59=(a59+a47);
  a47=(a17*a62);
  a36=(a21*a58);
  a47=(a47+a36);
  a36=(a47*a28);
  a59=(a59-a36);
  a20=(a20+a14);
  a14=(a20*a28);
  a10=(a10-a11);
  a11=(a10*a18);
  a14=(a14-a11);
  a06=(a06-a23);
  a06=(a06+a24);
  a06=(a06-a27);
  a27=(a06*a22);
  a14=(a14+a27);
  a27=(a13*a14);
  a27=(a59-a27);
  if (res[0]!=0) res[0][1]=a27;
  a27=(a03*a14);
  a24=(a15*a58);
  a23=(a25*a62);
  a11=(a24-a23);
  a11=(a28*a11);
  a36=(a62*a12);
  a02=(a15*a32);
  a63=(a36+a02);
  a63=(a18*a63);
  a11=(a11-a63);
  a63=(a58*a12);
  a64=(a25*a32);
  a63=(a63+a64);
  a64=(a63*a22);
  a11=(a11+a64);
  a27=(a27+a11);
  a27=(-a27);
  if (res[0]!=0) res[0][2]=a27;
  if (res[0]!=0) res[0][3]=a07;
  a27=(a10*a28);
  a64=(a20*a18);
  a27=(a27+a64);
  a64=(a61*a27);
  a65=(a06*a28);
  a66=(a20*a22);
  a65=(a65-a66);
  a66=(a65*a42);
  a64=(a64-a66);
  a66=(a06*a18);
  a67=(a10*a22);
  a66=(a66+a67);
  a67=(a66*a52);
  a64=(a64+a67);
  if (res[0]!=0) res[0][4]=a64;
  a64=(a57*a65);
  a67=(a27*a46);
  a64=(a64-a67);
  a67=(a66*a54);
  a64=(a64+a67);
  if (res[0]!=0) res[0][5]=a64;
  a64=(a09*a66);
  a67=(a27*a49);
  a64=(a64+a67);
  a67=(a65*a39);
  a64=(a64+a67);
  a64=(-a64);
  if (res[0]!=0) res[0][6]=a64;
  a64=(a43*a65);
  a67=(a48*a66);
  a64=(a64-a67);
  a67=(a38*a27);
  a64=(a64+a67);
  a67=(a64*a45);
  a68=(a50*a65);
  a69=(a44*a66);
  a68=(a68-a69);
  a69=(a34*a27);
  a68=(a68+a69);
  a69=(a68*a51);
  a67=(a67-a69);
  if (res[0]!=0) res[0][7]=a67;
  a67=(a37*a65);
  a69=(a40*a66);
  a67=(a67-a69);
  a69=(a33*a27);
  a67=(a67+a69);
  a69=(a67*a51);
  a70=(a64*a41);
  a69=(a69-a70);
  if (res[0]!=0) res[0][8]=a69;
  a69=(a68*a41);
  a70=(a67*a45);
  a69=(a69-a70);
  if (res[0]!=0) res[0][9]=a69;
  a69=arg[6]? arg[6][0] : 0;
  a69=(-a69);
  if (res[0]!=0) res[0][10]=a69;
  a69=(a20*a58);
  a70=(a03*a15);
  a70=(a69+a70);
  a71=(a10*a32);
  a70=(a70+a71);
  a72=(a13*a21);
  a70=(a70+a72);
  if (res[0]!=0) res[0][11]=a70;
  a70=(a25*a03);
  a72=(a20*a62);
  a32=(a06*a32);
  a72=(a72-a32);
  a70=(a70-a72);
  a32=(a13*a17);
  a70=(a70-a32);
  if (res[0]!=0) res[0][12]=a70;
  a62=(a10*a62);
  a70=(a03*a12);
  a70=(a62+a70);
  a58=(a06*a58);
  a70=(a70+a58);
  a32=(a13*a26);
  a70=(a70+a32);
  a70=(-a70);
  if (res[0]!=0) res[0][13]=a70;
  if (res[0]!=0) res[0][14]=a67;
  if (res[0]!=0) res[0][15]=a68;
  if (res[0]!=0) res[0][16]=a64;
  a64=(a27*a53);
  if (res[0]!=0) res[0][17]=a64;
  a64=(a65*a55);
  if (res[0]!=0) res[0][18]=a64;
  a64=(a66*a31);
  a64=(-a64);
  if (res[0]!=0) res[0][19]=a64;
  a64=(a27*a55);
  if (res[0]!=0) res[0][20]=a64;
  a27=(a27*a31);
  if (res[0]!=0) res[0][21]=a27;
  a27=(a65*a53);
  if (res[0]!=0) res[0][22]=a27;
  a65=(a65*a31);
  if (res[0]!=0) res[0][23]=a65;
  a65=(a66*a53);
  a65=(-a65);
  if (res[0]!=0) res[0][24]=a65;
  a66=(a66*a55);
  a66=(-a66);
  if (res[0]!=0) res[0][25]=a66;
  a00=(a00*a01);
  a04=(a04+a00);
  a00=(a30*a04);
  a00=(a00-a59);
  if (res[0]!=0) res[0][26]=a00;
  a14=(a14*a04);
  a29=(a29-a14);
  if (res[0]!=0) res[0][27]=a29;
  a72=(a72*a18);
  a71=(a71+a69);
  a71=(a22*a71);
  a72=(a72-a71);
  a58=(a58+a62);
  a58=(a28*a58);
  a72=(a72+a58);
  a30=(a30*a03);
  a30=(a72-a30);
  if (res[0]!=0) res[0][28]=a30;
  if (res[0]!=0) res[0][29]=a07;
  a30=(a25*a28);
  a58=(a12*a18);
  a30=(a30+a58);
  a58=(a61*a30);
  a62=(a12*a22);
  a71=(a15*a28);
  a62=(a62+a71);
  a71=(a62*a42);
  a58=(a58+a71);
  a71=(a25*a22);
  a69=(a15*a18);
  a71=(a71-a69);
  a69=(a71*a52);
  a58=(a58+a69);
  a58=(-a58);
  if (res[0]!=0) res[0][30]=a58;
  a58=(a57*a62);
  a69=(a71*a54);
  a58=(a58-a69);
  a69=(a30*a46);
  a58=(a58+a69);
  if (res[0]!=0) res[0][31]=a58;
  a58=(a09*a71);
  a69=(a62*a39);
  a58=(a58-a69);
  a69=(a30*a49);
  a58=(a58+a69);
  if (res[0]!=0) res[0][32]=a58;
  a58=(a48*a71);
  a69=(a43*a62);
  a58=(a58+a69);
  a69=(a38*a30);
  a58=(a58-a69);
  a69=(a58*a45);
  a29=(a44*a71);
  a00=(a50*a62);
  a29=(a29+a00);
  a00=(a34*a30);
  a29=(a29-a00);
  a00=(a29*a51);
  a69=(a69-a00);
  if (res[0]!=0) res[0][33]=a69;
  a69=(a40*a71);
  a00=(a37*a62);
  a69=(a69+a00);
  a00=(a33*a30);
  a69=(a69-a00);
  a00=(a69*a51);
  a59=(a58*a41);
  a00=(a00-a59);
  if (res[0]!=0) res[0][34]=a00;
  a00=(a29*a41);
  a59=(a69*a45);
  a00=(a00-a59);
  if (res[0]!=0) res[0][35]=a00;
  a00=arg[6]? arg[6][1] : 0;
  a00=(-a00);
  if (res[0]!=0) res[0][36]=a00;
  a00=(a21*a04);
  a00=(a00-a63);
  a63=(a06*a03);
  a00=(a00-a63);
  if (res[0]!=0) res[0][37]=a00;
  a00=(a17*a04);
  a02=(a02-a00);
  a00=(a10*a03);
  a02=(a02+a00);
  a02=(a02+a36);
  if (res[0]!=0) res[0][38]=a02;
  a02=(a26*a04);
  a23=(a23-a02);
  a03=(a20*a03);
  a23=(a23-a03);
  a23=(a23-a24);
  if (res[0]!=0) res[0][39]=a23;
  if (res[0]!=0) res[0][40]=a69;
  if (res[0]!=0) res[0][41]=a29;
  if (res[0]!=0) res[0][42]=a58;
  a58=(a30*a53);
  a58=(-a58);
  if (res[0]!=0) res[0][43]=a58;
  a58=(a62*a55);
  if (res[0]!=0) res[0][44]=a58;
  a58=(a71*a31);
  if (res[0]!=0) res[0][45]=a58;
  a58=(a30*a55);
  a58=(-a58);
  if (res[0]!=0) res[0][46]=a58;
  a30=(a30*a31);
  a30=(-a30);
  if (res[0]!=0) res[0][47]=a30;
  a30=(a62*a53);
  if (res[0]!=0) res[0][48]=a30;
  a62=(a62*a31);
  if (res[0]!=0) res[0][49]=a62;
  a62=(a71*a53);
  if (res[0]!=0) res[0][50]=a62;
  a71=(a71*a55);
  if (res[0]!=0) res[0][51]=a71;
  a71=(a19*a04);
  a11=(a11+a71);
  if (res[0]!=0) res[0][52]=a11;
  a19=(a19*a05);
  a19=(a19*a16);
  a19=(a19+a72);
  a19=(-a19);
  if (res[0]!=0) res[0][53]=a19;
  a08=(a08-a14);
  if (res[0]!=0) res[0][54]=a08;
  if (res[0]!=0) res[0][55]=a07;
  a07=(a26*a18);
  a08=(a17*a28);
  a07=(a07-a08);
  a61=(a07*a61);
  a18=(a21*a18);
  a17=(a17*a22);
  a18=(a18+a17);
  a52=(a18*a52);
  a61=(a61-a52);
  a26=(a26*a22);
  a21=(a21*a28);
  a26=(a26+a21);
  a42=(a26*a42);
  a61=(a61+a42);
  if (res[0]!=0) res[0][56]=a61;
  a57=(a26*a57);
  a54=(a18*a54);
  a57=(a57+a54);
  a46=(a07*a46);
  a57=(a57+a46);
  a57=(-a57);
  if (res[0]!=0) res[0][57]=a57;
  a09=(a18*a09);
  a39=(a26*a39);
  a09=(a09+a39);
  a49=(a07*a49);
  a09=(a09-a49);
  if (res[0]!=0) res[0][58]=a09;
  a48=(a18*a48);
  a43=(a26*a43);
  a48=(a48-a43);
  a38=(a07*a38);
  a48=(a48+a38);
  a38=(a48*a45);
  a44=(a18*a44);
  a50=(a26*a50);
  a44=(a44-a50);
  a34=(a07*a34);
  a44=(a44+a34);
  a34=(a44*a51);
  a38=(a38-a34);
  if (res[0]!=0) res[0][59]=a38;
  a40=(a18*a40);
  a37=(a26*a37);
  a40=(a40-a37);
  a33=(a07*a33);
  a40=(a40+a33);
  a51=(a40*a51);
  a33=(a48*a41);
  a51=(a51-a33);
  if (res[0]!=0) res[0][60]=a51;
  a41=(a44*a41);
  a45=(a40*a45);
  a41=(a41-a45);
  if (res[0]!=0) res[0][61]=a41;
  a41=arg[6]? arg[6][2] : 0;
  a41=(-a41);
  if (res[0]!=0) res[0][62]=a41;
  a06=(a13*a06);
  a35=(a35+a06);
  a15=(a15*a04);
  a35=(a35+a15);
  a35=(a35-a56);
  if (res[0]!=0) res[0][63]=a35;
  a25=(a25*a04);
  a25=(a25-a60);
  a10=(a13*a10);
  a25=(a25-a10);
  if (res[0]!=0) res[0][64]=a25;
  a13=(a13*a20);
  a47=(a47+a13);
  a12=(a12*a04);
  a47=(a47-a12);
  if (res[0]!=0) res[0][65]=a47;
  if (res[0]!=0) res[0][66]=a40;
  if (res[0]!=0) res[0][67]=a44;
  if (res[0]!=0) res[0][68]=a48;
  a48=(a07*a53);
  if (res[0]!=0) res[0][69]=a48;
  a48=(a26*a55);
  a48=(-a48);
  if (res[0]!=0) res[0][70]=a48;
  a48=(a18*a31);
  if (res[0]!=0) res[0][71]=a48;
  a48=(a07*a55);
  if (res[0]!=0) res[0][72]=a48;
  a07=(a07*a31);
  if (res[0]!=0) res[0][73]=a07;
  a07=(a26*a53);
  a07=(-a07);
  if (res[0]!=0) res[0][74]=a07;
  a26=(a26*a31);
  a26=(-a26);
  if (res[0]!=0) res[0][75]=a26;
  a53=(a18*a53);
  if (res[0]!=0) res[0][76]=a53;
  a18=(a18*a55);
  if (res[0]!=0) res[0][77]=a18;
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


