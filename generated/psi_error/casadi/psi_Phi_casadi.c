/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) psi_Phi_casadi__ ## ID
#endif

#include <math.h>
#include "../src/psi_math.h"
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
CASADI_SYMBOL_EXPORT void psi_Phi_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int psi_Phi_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int psi_Phi_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {1, 1, 1};
static const casadi_int casadi_s2[3] = {60, 1, 1};

/* psi_Phi_casadi:(lon_lat_height[3],v_n[3],f_n[3],dt)->(out_Phi[60]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40;
  a00=1.;
  a01=arg[1]? arg[1][2] : 0;
  a02=arg[0]? arg[0][2] : 0;
  a03=6378137.;
  a04=6.6943799901413173e-03;
  a05=arg[0]? arg[0][1] : 0;
  a06=sin(a05);
  a07=(a06*a06);
  a08=(a04*a07);
  a08=(a00-a08);
  a09=sqrt(a08);
  a10=(a00/a09);
  a03=(a03*a10);
  a11=(a02+a03);
  a12=(a00/a11);
  a13=(a01*a12);
  a14=arg[1]? arg[1][1] : 0;
  a15=6.3354393272928204e+06;
  a09=(a08*a09);
  a15=(a15/a09);
  a09=(a02+a15);
  a16=(a00/a09);
  a17=(a14*a16);
  a05=cos(a05);
  a18=(a05*a06);
  a08=(a00/a08);
  a19=(a18*a08);
  a03=(a19*a03);
  a03=(a04*a03);
  a03=(a03*a12);
  a20=(a00/a05);
  a21=(a06*a20);
  a03=(a03-a21);
  a03=(a17*a03);
  a13=(a13+a03);
  a03=arg[3]? arg[3][0] : 0;
  a13=(a13*a03);
  a22=(a00-a13);
  a23=(a13*a13);
  a20=(a12*a20);
  a24=(a20*a09);
  a25=arg[1]? arg[1][0] : 0;
  a25=(a25*a12);
  a21=(a21*a25);
  a24=(a24*a21);
  a24=(a24*a03);
  a11=(a05*a11);
  a12=(a11*a16);
  a12=(a12*a21);
  a12=(a12*a03);
  a26=(a24*a12);
  a23=(a23-a26);
  a27=(a20*a25);
  a27=(a27*a03);
  a11=(a11*a25);
  a11=(a11*a03);
  a28=(a27*a11);
  a23=(a23-a28);
  a20=(a20*a03);
  a29=7.3745167729419953e-14;
  a30=(a02*a02);
  a29=(a29*a30);
  a29=(a00+a29);
  a30=1.5678559428873979e-07;
  a31=2.0136051943431768e+00;
  a32=1.3411242658989924e-02;
  a32=(a32*a07);
  a31=(a31-a32);
  a31=(a02*a31);
  a30=(a30*a31);
  a29=(a29-a30);
  a30=9.7803253359000006e+00;
  a31=1.8894147482439335e-02;
  a31=(a31*a07);
  a31=(a30+a31);
  a31=(a31*a10);
  a32=(a29*a31);
  a33=(a05*a32);
  a33=(a33*a03);
  a34=(a20*a33);
  a23=(a23-a34);
  a35=5.0000000000000000e-01;
  a23=(a23*a35);
  a22=(a22+a23);
  if (res[0]!=0) res[0][0]=a22;
  a22=(a13*a24);
  a01=(a01*a16);
  a23=2.0083139970423949e-02;
  a19=(a19*a15);
  a23=(a23*a19);
  a23=(a14*a23);
  a09=(a09*a09);
  a23=(a23/a09);
  a01=(a01+a23);
  a01=(a01*a03);
  a23=(a24*a01);
  a22=(a22+a23);
  a14=(a14*a03);
  a23=(a27*a14);
  a22=(a22+a23);
  a22=(a22*a35);
  a22=(a24-a22);
  if (res[0]!=0) res[0][1]=a22;
  a22=(a13*a27);
  a23=(a17*a16);
  a23=(a23*a03);
  a09=(a24*a23);
  a22=(a22-a09);
  a22=(a22*a35);
  a22=(a22-a27);
  if (res[0]!=0) res[0][2]=a22;
  a22=(a13*a20);
  a22=(a22*a35);
  a22=(a20-a22);
  if (res[0]!=0) res[0][3]=a22;
  a16=(a03*a16);
  a22=(a24*a16);
  a09=1.4584230000000000e-04;
  a19=(a09*a06);
  a19=(a19+a21);
  a19=(a19*a03);
  a15=(a20*a19);
  a22=(a22+a15);
  a22=(a22*a35);
  if (res[0]!=0) res[0][4]=a22;
  a22=(a27*a03);
  a09=(a09*a05);
  a09=(a09+a25);
  a09=(a09*a03);
  a15=(a20*a09);
  a22=(a22+a15);
  a22=(a22*a35);
  a22=(-a22);
  if (res[0]!=0) res[0][5]=a22;
  a22=arg[2]? arg[2][2] : 0;
  a22=(a22*a03);
  a15=(a20*a22);
  a15=(a15*a35);
  a15=(-a15);
  if (res[0]!=0) res[0][6]=a15;
  a15=arg[2]? arg[2][1] : 0;
  a15=(a15*a03);
  a36=(a20*a15);
  a36=(a36*a35);
  if (res[0]!=0) res[0][7]=a36;
  a36=(a12*a13);
  a37=(a01*a12);
  a36=(a36+a37);
  a37=(a23*a11);
  a36=(a36-a37);
  a36=(a36*a35);
  a36=(a36-a12);
  if (res[0]!=0) res[0][8]=a36;
  a36=(a00-a01);
  a37=(a01*a01);
  a37=(a37-a26);
  a26=(a23*a14);
  a37=(a37-a26);
  a32=(a32*a03);
  a38=(a16*a32);
  a37=(a37-a38);
  a37=(a37*a35);
  a36=(a36+a37);
  if (res[0]!=0) res[0][9]=a36;
  a36=(a12*a27);
  a37=(a01*a23);
  a36=(a36+a37);
  a36=(a36*a35);
  a36=(a36-a23);
  if (res[0]!=0) res[0][10]=a36;
  a36=(a12*a20);
  a37=(a16*a19);
  a36=(a36+a37);
  a36=(a36*a35);
  a36=(-a36);
  if (res[0]!=0) res[0][11]=a36;
  a36=(a01*a16);
  a36=(a36*a35);
  a36=(a16-a36);
  if (res[0]!=0) res[0][12]=a36;
  a36=(a23*a03);
  a36=(-a36);
  if (res[0]!=0) res[0][13]=a36;
  a36=(a16*a22);
  a36=(a36*a35);
  if (res[0]!=0) res[0][14]=a36;
  a36=arg[2]? arg[2][0] : 0;
  a36=(a36*a03);
  a37=(a16*a36);
  a37=(a37*a35);
  a37=(-a37);
  if (res[0]!=0) res[0][15]=a37;
  a37=(a11*a13);
  a39=(a14*a12);
  a37=(a37+a39);
  a37=(a37*a35);
  a37=(a11-a37);
  if (res[0]!=0) res[0][16]=a37;
  a37=(a11*a24);
  a39=(a14*a01);
  a37=(a37-a39);
  a39=4.2053793008804680e-09;
  a40=(a18*a02);
  a40=(a40*a31);
  a39=(a39*a40);
  a18=(a18*a10);
  a18=(a18*a29);
  a29=3.8637053131731361e-03;
  a10=1.2932555768154467e-05;
  a10=(a10*a07);
  a04=(a04+a10);
  a04=(a04*a08);
  a29=(a29+a04);
  a18=(a18*a29);
  a30=(a30*a18);
  a39=(a39+a30);
  a39=(a39*a03);
  a30=(a03*a39);
  a37=(a37-a30);
  a37=(a37*a35);
  a37=(a14+a37);
  if (res[0]!=0) res[0][17]=a37;
  a28=(a28+a26);
  a37=1.4749033545883991e-13;
  a37=(a37*a02);
  a02=2.1026896504402340e-09;
  a02=(a02*a07);
  a37=(a37+a02);
  a02=3.1570428705798834e-07;
  a37=(a37-a02);
  a37=(a37*a31);
  a37=(a37*a03);
  a31=(a03*a37);
  a28=(a28+a31);
  a28=(a28*a35);
  a28=(a00-a28);
  if (res[0]!=0) res[0][18]=a28;
  a20=(a11*a20);
  a28=(a03*a09);
  a20=(a20+a28);
  a20=(a20*a35);
  if (res[0]!=0) res[0][19]=a20;
  a20=(a14*a16);
  if (res[0]!=0) res[0][20]=a20;
  if (res[0]!=0) res[0][21]=a03;
  a20=(a03*a15);
  a20=(a20*a35);
  a20=(-a20);
  if (res[0]!=0) res[0][22]=a20;
  a20=(a03*a36);
  a20=(a20*a35);
  if (res[0]!=0) res[0][23]=a20;
  a13=(a33*a13);
  a13=(a13*a35);
  a13=(a13-a33);
  if (res[0]!=0) res[0][24]=a13;
  a13=(a09*a39);
  a24=(a33*a24);
  a20=(a19*a32);
  a24=(a24+a20);
  a13=(a13-a24);
  a13=(a13*a35);
  if (res[0]!=0) res[0][25]=a13;
  a27=(a33*a27);
  a13=(a09*a37);
  a27=(a27+a13);
  a27=(a27*a35);
  if (res[0]!=0) res[0][26]=a27;
  a27=(a19*a19);
  a34=(a34+a27);
  a13=(a09*a09);
  a34=(a34+a13);
  a34=(a34*a35);
  a34=(a00-a34);
  if (res[0]!=0) res[0][27]=a34;
  a17=(a17*a03);
  a34=(a17*a09);
  a34=(a34*a35);
  a24=(a19-a34);
  if (res[0]!=0) res[0][28]=a24;
  a24=(a17*a19);
  a24=(a24*a35);
  a20=(a09+a24);
  a20=(-a20);
  if (res[0]!=0) res[0][29]=a20;
  a20=(a19*a22);
  a28=(a09*a15);
  a02=(a20+a28);
  a07=7.2921149999999999e-05;
  a06=(a07*a06);
  a21=(a21+a06);
  a21=(a21*a03);
  a06=(a22*a21);
  a02=(a02+a06);
  a07=(a07*a05);
  a25=(a25+a07);
  a25=(a25*a03);
  a03=(a15*a25);
  a02=(a02+a03);
  a02=(a02*a35);
  if (res[0]!=0) res[0][30]=a02;
  a02=(a17*a15);
  a07=(a09*a36);
  a07=(a02-a07);
  a07=(a07*a35);
  a07=(a07-a22);
  if (res[0]!=0) res[0][31]=a07;
  a07=(a17*a22);
  a05=(a19*a36);
  a05=(a07-a05);
  a05=(a05*a35);
  a05=(a15+a05);
  if (res[0]!=0) res[0][32]=a05;
  a05=(a32*a12);
  a30=(a19*a33);
  a05=(a05+a30);
  a05=(a05*a35);
  if (res[0]!=0) res[0][33]=a05;
  a05=(a32*a01);
  a30=(a17*a39);
  a05=(a05+a30);
  a05=(a05*a35);
  a05=(a05-a32);
  if (res[0]!=0) res[0][34]=a05;
  a05=(a32*a23);
  a30=(a17*a37);
  a05=(a05+a30);
  a05=(a05*a35);
  if (res[0]!=0) res[0][35]=a05;
  a34=(a19+a34);
  a34=(-a34);
  if (res[0]!=0) res[0][36]=a34;
  a38=(a38+a27);
  a38=(a38+a26);
  a38=(a38*a35);
  a38=(a00-a38);
  if (res[0]!=0) res[0][37]=a38;
  a38=(a09*a19);
  a27=(a38*a35);
  a27=(a27-a17);
  if (res[0]!=0) res[0][38]=a27;
  a27=(a36*a25);
  a02=(a02-a27);
  a02=(a02*a35);
  a02=(a22+a02);
  if (res[0]!=0) res[0][39]=a02;
  a02=(a17*a36);
  a20=(a20-a02);
  a20=(a20+a06);
  a20=(a20-a02);
  a20=(a20*a35);
  if (res[0]!=0) res[0][40]=a20;
  a19=(a19*a15);
  a20=(a22*a25);
  a19=(a19+a20);
  a19=(a19*a35);
  a19=(a36+a19);
  a19=(-a19);
  if (res[0]!=0) res[0][41]=a19;
  a12=(a39*a12);
  a11=(a37*a11);
  a12=(a12-a11);
  a33=(a09*a33);
  a12=(a12-a33);
  a12=(a12*a35);
  if (res[0]!=0) res[0][42]=a12;
  a01=(a39*a01);
  a14=(a37*a14);
  a01=(a01-a14);
  a32=(a17*a32);
  a01=(a01-a32);
  a01=(a01*a35);
  a01=(a01-a39);
  if (res[0]!=0) res[0][43]=a01;
  a23=(a39*a23);
  a23=(a23*a35);
  a23=(a23-a37);
  if (res[0]!=0) res[0][44]=a23;
  a24=(a09-a24);
  if (res[0]!=0) res[0][45]=a24;
  a39=(a39*a16);
  a38=(a38-a39);
  a38=(a38*a35);
  a38=(a17+a38);
  if (res[0]!=0) res[0][46]=a38;
  a31=(a31+a13);
  a31=(a31+a26);
  a31=(a31*a35);
  a31=(a00-a31);
  if (res[0]!=0) res[0][47]=a31;
  a31=(a36*a21);
  a07=(a07-a31);
  a07=(a07*a35);
  a07=(a07-a15);
  if (res[0]!=0) res[0][48]=a07;
  a09=(a09*a22);
  a15=(a15*a21);
  a09=(a09+a15);
  a09=(a09*a35);
  a36=(a36-a09);
  if (res[0]!=0) res[0][49]=a36;
  a28=(a28-a02);
  a28=(a28+a03);
  a28=(a28-a02);
  a28=(a28*a35);
  if (res[0]!=0) res[0][50]=a28;
  a28=(a21*a21);
  a02=(a25*a25);
  a03=(a28+a02);
  a03=(a03*a35);
  a03=(a00-a03);
  if (res[0]!=0) res[0][51]=a03;
  a03=(a17*a25);
  a03=(a03*a35);
  a36=(a21-a03);
  if (res[0]!=0) res[0][52]=a36;
  a36=(a17*a21);
  a36=(a36*a35);
  a09=(a25+a36);
  a09=(-a09);
  if (res[0]!=0) res[0][53]=a09;
  a03=(a21+a03);
  a03=(-a03);
  if (res[0]!=0) res[0][54]=a03;
  a28=(a28+a26);
  a28=(a28*a35);
  a28=(a00-a28);
  if (res[0]!=0) res[0][55]=a28;
  a21=(a25*a21);
  a21=(a21*a35);
  a28=(a21-a17);
  if (res[0]!=0) res[0][56]=a28;
  a25=(a25-a36);
  if (res[0]!=0) res[0][57]=a25;
  a17=(a17+a21);
  if (res[0]!=0) res[0][58]=a17;
  a02=(a02+a26);
  a02=(a02*a35);
  a00=(a00-a02);
  if (res[0]!=0) res[0][59]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int psi_Phi_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int psi_Phi_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void psi_Phi_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void psi_Phi_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void psi_Phi_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int psi_Phi_casadi_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int psi_Phi_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real psi_Phi_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* psi_Phi_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    case 2: return "f_n";
    case 3: return "dt";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* psi_Phi_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Phi";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* psi_Phi_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s0;
    case 3: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* psi_Phi_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int psi_Phi_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int psi_Phi_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


