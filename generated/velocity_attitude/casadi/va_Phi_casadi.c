/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_Phi_casadi__ ## ID
#endif

#include <math.h>
#include "../src/va_math.h"
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
CASADI_SYMBOL_EXPORT void va_Phi_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_Phi_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_Phi_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {82, 1, 1};

/* va_Phi_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],f_b[3],dt)->(out_Phi[82]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  a00=1.;
  a01=arg[4]? arg[4][0] : 0;
  a02=arg[0]? arg[0][2] : 0;
  a03=6378137.;
  a04=6.6943799901413173e-03;
  a05=arg[0]? arg[0][0] : 0;
  a06=sin(a05);
  a07=(a06*a06);
  a04=(a04*a07);
  a04=(a00-a04);
  a07=sqrt(a04);
  a03=(a03/a07);
  a03=(a02+a03);
  a03=(a00/a03);
  a08=(a01*a03);
  a09=arg[3]? arg[3][0] : 0;
  a10=2.;
  a11=arg[2]? arg[2][1] : 0;
  a12=(a10*a11);
  a13=arg[2]? arg[2][3] : 0;
  a14=(a12*a13);
  a15=arg[2]? arg[2][0] : 0;
  a16=(a10*a15);
  a17=arg[2]? arg[2][2] : 0;
  a18=(a16*a17);
  a19=(a14-a18);
  a20=(a09*a19);
  a21=arg[3]? arg[3][1] : 0;
  a22=(a16*a11);
  a23=(a10*a17);
  a23=(a23*a13);
  a24=(a22+a23);
  a25=(a21*a24);
  a20=(a20+a25);
  a25=arg[3]? arg[3][2] : 0;
  a26=(a13*a13);
  a11=(a11*a11);
  a27=(a26-a11);
  a28=(a17*a17);
  a27=(a27-a28);
  a15=(a15*a15);
  a27=(a27+a15);
  a29=(a25*a27);
  a20=(a20+a29);
  a20=(a20*a01);
  a29=(a08*a20);
  a05=cos(a05);
  a30=(a06/a05);
  a31=arg[1]? arg[1][1] : 0;
  a31=(a31*a03);
  a32=(a30*a31);
  a33=7.2921149999999999e-05;
  a06=(a33*a06);
  a34=(a32+a06);
  a34=(a34*a01);
  a35=(a34*a34);
  a36=arg[1]? arg[1][0] : 0;
  a37=6.3354393272928204e+06;
  a04=(a04*a07);
  a37=(a37/a04);
  a02=(a02+a37);
  a02=(a00/a02);
  a37=(a36*a02);
  a04=(a37*a01);
  a07=(a04*a04);
  a38=(a35+a07);
  a38=(a29-a38);
  a39=5.0000000000000000e-01;
  a38=(a38*a39);
  a38=(a00+a38);
  if (res[0]!=0) res[0][0]=a38;
  a33=(a33*a05);
  a33=(a31+a33);
  a33=(a33*a01);
  a38=(a33*a04);
  a38=(a38*a39);
  a40=(a34+a38);
  a40=(-a40);
  if (res[0]!=0) res[0][1]=a40;
  a40=(a33*a34);
  a15=(a15-a26);
  a26=(a15+a11);
  a26=(a26-a28);
  a41=(a09*a26);
  a12=(a12*a17);
  a16=(a16*a13);
  a13=(a12-a16);
  a17=(a21*a13);
  a41=(a41+a17);
  a18=(a18+a14);
  a14=(a25*a18);
  a41=(a41+a14);
  a41=(a41*a01);
  a14=(a08*a41);
  a14=(a40+a14);
  a14=(a14*a39);
  a14=(a04-a14);
  if (res[0]!=0) res[0][2]=a14;
  a14=(a01*a02);
  a17=(a34*a14);
  a06=(-a06);
  a06=(a10*a06);
  a06=(a06-a32);
  a42=(a06*a01);
  a43=(a08*a42);
  a44=(a17-a43);
  a44=(a44*a39);
  if (res[0]!=0) res[0][3]=a44;
  a44=arg[1]? arg[1][2] : 0;
  a45=(a44*a03);
  a30=(a30*a03);
  a36=(a36*a30);
  a45=(a45+a36);
  a45=(a45*a01);
  a36=(a08*a45);
  a30=(a30*a01);
  a03=(a04*a30);
  a36=(a36-a03);
  a36=(a36*a39);
  a36=(a08+a36);
  if (res[0]!=0) res[0][4]=a36;
  a36=1.4584230000000000e-04;
  a36=(a36*a05);
  a36=(a36+a31);
  a05=(a36*a01);
  a03=(a08*a05);
  a03=(a03*a39);
  if (res[0]!=0) res[0][5]=a03;
  a26=(a26*a01);
  a19=(a19*a01);
  a03=(a04*a19);
  a16=(a16+a12);
  a12=(a16*a01);
  a46=(a34*a12);
  a46=(a03-a46);
  a46=(a46*a39);
  a46=(a26+a46);
  if (res[0]!=0) res[0][6]=a46;
  a13=(a13*a01);
  a24=(a24*a01);
  a46=(a04*a24);
  a15=(a15-a11);
  a15=(a15+a28);
  a28=(a15*a01);
  a11=(a34*a28);
  a11=(a46-a11);
  a11=(a11*a39);
  a11=(a13+a11);
  if (res[0]!=0) res[0][7]=a11;
  a18=(a18*a01);
  a27=(a27*a01);
  a11=(a04*a27);
  a23=(a23-a22);
  a22=(a23*a01);
  a47=(a34*a22);
  a47=(a11-a47);
  a47=(a47*a39);
  a47=(a18+a47);
  if (res[0]!=0) res[0][8]=a47;
  a47=(a08*a12);
  a47=(a47*a39);
  a47=(-a47);
  if (res[0]!=0) res[0][9]=a47;
  a47=(a08*a28);
  a47=(a47*a39);
  a47=(-a47);
  if (res[0]!=0) res[0][10]=a47;
  a47=(a08*a22);
  a47=(a47*a39);
  a47=(-a47);
  if (res[0]!=0) res[0][11]=a47;
  a38=(a34-a38);
  if (res[0]!=0) res[0][12]=a38;
  a38=(a14*a20);
  a47=(a33*a33);
  a35=(a35+a47);
  a35=(a38-a35);
  a35=(a35*a39);
  a35=(a00+a35);
  if (res[0]!=0) res[0][13]=a35;
  a35=(a04*a34);
  a09=(a09*a16);
  a21=(a21*a15);
  a09=(a09+a21);
  a25=(a25*a23);
  a09=(a09+a25);
  a09=(a09*a01);
  a25=(a14*a09);
  a25=(a35-a25);
  a25=(a25*a39);
  a25=(a33+a25);
  if (res[0]!=0) res[0][14]=a25;
  a44=(a44*a02);
  a44=(a44*a01);
  a02=(a14*a44);
  a02=(a02*a39);
  a02=(a14+a02);
  a02=(-a02);
  if (res[0]!=0) res[0][15]=a02;
  if (res[0]!=0) res[0][16]=a17;
  a17=(a14*a04);
  a17=(a17*a39);
  a17=(-a17);
  if (res[0]!=0) res[0][17]=a17;
  a17=(a34*a26);
  a02=(a33*a19);
  a17=(a17+a02);
  a17=(a17*a39);
  a17=(a12+a17);
  if (res[0]!=0) res[0][18]=a17;
  a17=(a34*a13);
  a02=(a33*a24);
  a17=(a17+a02);
  a17=(a17*a39);
  a17=(a28+a17);
  if (res[0]!=0) res[0][19]=a17;
  a17=(a34*a18);
  a02=(a33*a27);
  a17=(a17+a02);
  a17=(a17*a39);
  a17=(a22+a17);
  if (res[0]!=0) res[0][20]=a17;
  a17=(a14*a26);
  a17=(a17*a39);
  if (res[0]!=0) res[0][21]=a17;
  a17=(a14*a13);
  a17=(a17*a39);
  if (res[0]!=0) res[0][22]=a17;
  a17=(a14*a18);
  a17=(a17*a39);
  if (res[0]!=0) res[0][23]=a17;
  a17=(a30*a20);
  a40=(a40+a17);
  a40=(a40*a39);
  a40=(a04+a40);
  a40=(-a40);
  if (res[0]!=0) res[0][24]=a40;
  a35=(a35*a39);
  a35=(a35-a33);
  if (res[0]!=0) res[0][25]=a35;
  a35=(a30*a41);
  a07=(a07+a47);
  a07=(a35-a07);
  a07=(a07*a39);
  a07=(a00+a07);
  if (res[0]!=0) res[0][26]=a07;
  a07=(a33*a14);
  a47=(a30*a42);
  a07=(a07+a47);
  a07=(a07*a39);
  if (res[0]!=0) res[0][27]=a07;
  a07=(a04*a08);
  a47=(a30*a45);
  a07=(a07+a47);
  a07=(a07*a39);
  a07=(a30+a07);
  a07=(-a07);
  if (res[0]!=0) res[0][28]=a07;
  a43=(a43*a39);
  if (res[0]!=0) res[0][29]=a43;
  a43=(a04*a26);
  a07=(a33*a12);
  a43=(a43+a07);
  a07=(a43*a39);
  a07=(a19-a07);
  if (res[0]!=0) res[0][30]=a07;
  a07=(a04*a13);
  a47=(a33*a28);
  a07=(a07+a47);
  a47=(a07*a39);
  a47=(a24-a47);
  if (res[0]!=0) res[0][31]=a47;
  a47=(a04*a18);
  a40=(a33*a22);
  a47=(a47+a40);
  a40=(a47*a39);
  a40=(a27-a40);
  if (res[0]!=0) res[0][32]=a40;
  a40=(a30*a12);
  a40=(a40*a39);
  if (res[0]!=0) res[0][33]=a40;
  a40=(a30*a28);
  a40=(a40*a39);
  if (res[0]!=0) res[0][34]=a40;
  a40=(a30*a22);
  a40=(a40*a39);
  if (res[0]!=0) res[0][35]=a40;
  a06=(a06-a32);
  a06=(a06*a01);
  a32=(a06*a20);
  a40=(a20*a34);
  a17=(a09*a04);
  a02=(a40+a17);
  a32=(a32-a02);
  a32=(a32-a17);
  a32=(a32*a39);
  if (res[0]!=0) res[0][36]=a32;
  a32=(a41*a04);
  a02=(a09*a33);
  a25=(a44*a20);
  a02=(a02+a25);
  a02=(a32-a02);
  a02=(a02*a39);
  a02=(a02-a20);
  if (res[0]!=0) res[0][37]=a02;
  a02=(a44*a09);
  a25=(a20*a33);
  a02=(a02-a25);
  a25=(a06*a41);
  a02=(a02-a25);
  a02=(a02*a39);
  a02=(a09+a02);
  if (res[0]!=0) res[0][38]=a02;
  a02=(a00+a44);
  a25=(a44*a44);
  a38=(a38+a25);
  a25=(a06*a42);
  a38=(a38-a25);
  a10=(a10*a37);
  a10=(a10*a01);
  a37=(a04*a10);
  a38=(a38-a37);
  a38=(a38*a39);
  a02=(a02+a38);
  if (res[0]!=0) res[0][39]=a02;
  a02=(a44*a06);
  a30=(a09*a30);
  a02=(a02-a30);
  a30=(a06*a45);
  a02=(a02+a30);
  a36=(a36+a31);
  a36=(a36*a01);
  a01=(a04*a36);
  a02=(a02-a01);
  a02=(a02*a39);
  a02=(a06+a02);
  if (res[0]!=0) res[0][40]=a02;
  a02=(a44*a04);
  a01=(a36*a42);
  a02=(a02+a01);
  a02=(a02*a39);
  a02=(a04+a02);
  if (res[0]!=0) res[0][41]=a02;
  a02=(a09*a19);
  a31=(a20*a12);
  a02=(a02-a31);
  a02=(a02*a39);
  if (res[0]!=0) res[0][42]=a02;
  a02=(a09*a24);
  a31=(a20*a28);
  a02=(a02-a31);
  a02=(a02*a39);
  if (res[0]!=0) res[0][43]=a02;
  a02=(a09*a27);
  a31=(a20*a22);
  a02=(a02-a31);
  a02=(a02*a39);
  if (res[0]!=0) res[0][44]=a02;
  a02=(a44*a26);
  a31=(a06*a12);
  a02=(a02+a31);
  a02=(a02+a03);
  a02=(a02*a39);
  a02=(a26+a02);
  a02=(-a02);
  if (res[0]!=0) res[0][45]=a02;
  a02=(a44*a13);
  a03=(a06*a28);
  a02=(a02+a03);
  a02=(a02+a46);
  a02=(a02*a39);
  a02=(a13+a02);
  a02=(-a02);
  if (res[0]!=0) res[0][46]=a02;
  a02=(a44*a18);
  a46=(a06*a22);
  a02=(a02+a46);
  a02=(a02+a11);
  a02=(a02*a39);
  a02=(a18+a02);
  a02=(-a02);
  if (res[0]!=0) res[0][47]=a02;
  a02=(a45*a20);
  a32=(a32+a02);
  a02=(a05*a09);
  a32=(a32-a02);
  a32=(a32*a39);
  a32=(a20+a32);
  if (res[0]!=0) res[0][48]=a32;
  a33=(a41*a33);
  a40=(a33-a40);
  a32=(a42*a20);
  a40=(a40+a32);
  a32=(a05*a41);
  a40=(a40+a32);
  a40=(a40*a39);
  if (res[0]!=0) res[0][49]=a40;
  a40=(a20*a04);
  a32=(a42*a09);
  a40=(a40-a32);
  a32=(a45*a41);
  a40=(a40-a32);
  a40=(a40*a39);
  a40=(a40-a41);
  if (res[0]!=0) res[0][50]=a40;
  a40=(a42*a44);
  a32=(a45*a42);
  a40=(a40+a32);
  a32=(a05*a10);
  a40=(a40+a32);
  a40=(a40*a39);
  a40=(a42+a40);
  a40=(-a40);
  if (res[0]!=0) res[0][51]=a40;
  a40=(a00+a45);
  a29=(a29+a35);
  a29=(a29-a25);
  a25=(a45*a45);
  a29=(a29+a25);
  a25=(a05*a36);
  a29=(a29-a25);
  a29=(a29*a39);
  a40=(a40+a29);
  if (res[0]!=0) res[0][52]=a40;
  a40=(a45*a05);
  a04=(a42*a04);
  a40=(a40-a04);
  a40=(a40*a39);
  a40=(a05+a40);
  if (res[0]!=0) res[0][53]=a40;
  a40=(a20*a26);
  a04=(a41*a19);
  a40=(a40-a04);
  a40=(a40*a39);
  if (res[0]!=0) res[0][54]=a40;
  a40=(a20*a13);
  a04=(a41*a24);
  a40=(a40-a04);
  a40=(a40*a39);
  if (res[0]!=0) res[0][55]=a40;
  a40=(a20*a18);
  a04=(a41*a27);
  a40=(a40-a04);
  a40=(a40*a39);
  if (res[0]!=0) res[0][56]=a40;
  a40=(a42*a26);
  a04=(a45*a12);
  a40=(a40-a04);
  a04=(a05*a19);
  a40=(a40-a04);
  a40=(a40*a39);
  a40=(a40-a12);
  if (res[0]!=0) res[0][57]=a40;
  a40=(a42*a13);
  a04=(a45*a28);
  a40=(a40-a04);
  a04=(a05*a24);
  a40=(a40-a04);
  a40=(a40*a39);
  a40=(a40-a28);
  if (res[0]!=0) res[0][58]=a40;
  a42=(a42*a18);
  a40=(a45*a22);
  a42=(a42-a40);
  a05=(a05*a27);
  a42=(a42-a05);
  a42=(a42*a39);
  a42=(a42-a22);
  if (res[0]!=0) res[0][59]=a42;
  a42=(a41*a34);
  a05=(a36*a20);
  a42=(a42-a05);
  a42=(a42*a39);
  a42=(a42-a09);
  if (res[0]!=0) res[0][60]=a42;
  a34=(a09*a34);
  a20=(a10*a20);
  a34=(a34+a20);
  a34=(a34*a39);
  a34=(a41+a34);
  if (res[0]!=0) res[0][61]=a34;
  a33=(a33-a17);
  a17=(a10*a09);
  a33=(a33-a17);
  a17=(a36*a41);
  a33=(a33+a17);
  a33=(a33*a39);
  if (res[0]!=0) res[0][62]=a33;
  a14=(a41*a14);
  a44=(a10*a44);
  a14=(a14+a44);
  a01=(a01-a14);
  a01=(a01*a39);
  a01=(a01-a10);
  if (res[0]!=0) res[0][63]=a01;
  a08=(a09*a08);
  a10=(a10*a06);
  a08=(a08+a10);
  a45=(a36*a45);
  a08=(a08+a45);
  a08=(a08*a39);
  a36=(a36+a08);
  a36=(-a36);
  if (res[0]!=0) res[0][64]=a36;
  a37=(a37+a25);
  a37=(a37*a39);
  a37=(a00-a37);
  if (res[0]!=0) res[0][65]=a37;
  a12=(a41*a12);
  a26=(a09*a26);
  a12=(a12-a26);
  a12=(a12*a39);
  if (res[0]!=0) res[0][66]=a12;
  a28=(a41*a28);
  a13=(a09*a13);
  a28=(a28-a13);
  a28=(a28*a39);
  if (res[0]!=0) res[0][67]=a28;
  a41=(a41*a22);
  a09=(a09*a18);
  a41=(a41-a09);
  a41=(a41*a39);
  if (res[0]!=0) res[0][68]=a41;
  a43=(a43-a19);
  if (res[0]!=0) res[0][69]=a43;
  a07=(a07-a24);
  if (res[0]!=0) res[0][70]=a07;
  a47=(a47-a27);
  if (res[0]!=0) res[0][71]=a47;
  if (res[0]!=0) res[0][72]=a00;
  if (res[0]!=0) res[0][73]=a00;
  if (res[0]!=0) res[0][74]=a00;
  if (res[0]!=0) res[0][75]=a00;
  if (res[0]!=0) res[0][76]=a00;
  if (res[0]!=0) res[0][77]=a00;
  if (res[0]!=0) res[0][78]=a00;
  if (res[0]!=0) res[0][79]=a00;
  if (res[0]!=0) res[0][80]=a00;
  if (res[0]!=0) res[0][81]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_Phi_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_Phi_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_Phi_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_Phi_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_Phi_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_Phi_casadi_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int va_Phi_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real va_Phi_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_Phi_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "f_b";
    case 4: return "dt";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_Phi_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Phi";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_Phi_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_Phi_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_Phi_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_Phi_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


