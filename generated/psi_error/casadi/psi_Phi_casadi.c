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
  a01=arg[1]? arg[1][1] : 0;
  a02=arg[0]? arg[0][2] : 0;
  a03=6.3354393272928204e+06;
  a04=6.6943799901413173e-03;
  a05=arg[0]? arg[0][1] : 0;
  a06=sin(a05);
  a07=(a06*a06);
  a08=(a04*a07);
  a08=(a00-a08);
  a09=sqrt(a08);
  a10=(a08*a09);
  a10=(a00/a10);
  a03=(a03*a10);
  a03=(a02+a03);
  a11=(a00/a03);
  a12=(a01*a11);
  a13=4.2697672707179969e+04;
  a14=6378137.;
  a15=(a00/a09);
  a14=(a14*a15);
  a14=(a02+a14);
  a16=(a00/a14);
  a17=(a06*a16);
  a05=cos(a05);
  a17=(a17*a05);
  a17=(a17*a10);
  a13=(a13*a17);
  a17=(a00/a05);
  a10=(a06*a17);
  a13=(a13-a10);
  a13=(a12*a13);
  a18=arg[1]? arg[1][2] : 0;
  a19=(a18*a16);
  a13=(a13+a19);
  a19=arg[3]? arg[3][0] : 0;
  a13=(a13*a19);
  a20=(a00-a13);
  a21=(a13*a13);
  a22=arg[1]? arg[1][0] : 0;
  a23=(a22*a17);
  a14=(a14*a14);
  a23=(a23/a14);
  a14=(a23*a10);
  a14=(a14*a03);
  a14=(a14*a19);
  a24=(a05*a22);
  a25=(a24*a11);
  a25=(a25*a10);
  a25=(a25*a19);
  a26=(a14*a25);
  a21=(a21-a26);
  a23=(a23*a19);
  a24=(a24*a19);
  a27=(a23*a24);
  a21=(a21-a27);
  a17=(a17*a16);
  a17=(a17*a19);
  a28=7.3745167729419953e-14;
  a29=(a02*a02);
  a28=(a28*a29);
  a28=(a00+a28);
  a29=1.5678559428873979e-07;
  a30=2.0136051943431768e+00;
  a31=1.3411242658989924e-02;
  a31=(a31*a07);
  a30=(a30-a31);
  a30=(a02*a30);
  a29=(a29*a30);
  a28=(a28-a29);
  a29=9.7803253359000006e+00;
  a30=1.8894147482439335e-02;
  a30=(a30*a07);
  a30=(a29+a30);
  a30=(a30*a15);
  a31=(a28*a30);
  a32=(a31*a05);
  a32=(a32*a19);
  a33=(a17*a32);
  a21=(a21-a33);
  a34=5.0000000000000000e-01;
  a21=(a21*a34);
  a20=(a20+a21);
  if (res[0]!=0) res[0][0]=a20;
  a20=(a13*a14);
  a18=(a18*a11);
  a21=1.2723551478415026e+05;
  a03=(a03*a03);
  a03=(a01/a03);
  a35=(a06*a05);
  a36=(a03*a35);
  a37=(a08*a08);
  a37=(a37*a09);
  a36=(a36/a37);
  a21=(a21*a36);
  a18=(a18+a21);
  a18=(a18*a19);
  a21=(a14*a18);
  a20=(a20+a21);
  a01=(a01*a19);
  a21=(a23*a01);
  a20=(a20+a21);
  a20=(a20*a34);
  a20=(a14-a20);
  if (res[0]!=0) res[0][1]=a20;
  a20=(a13*a23);
  a03=(a03*a19);
  a21=(a14*a03);
  a20=(a20-a21);
  a20=(a20*a34);
  a20=(a20-a23);
  if (res[0]!=0) res[0][2]=a20;
  a20=(a13*a17);
  a20=(a20*a34);
  a20=(a17-a20);
  if (res[0]!=0) res[0][3]=a20;
  a11=(a19*a11);
  a20=(a14*a11);
  a22=(a22*a16);
  a10=(a22*a10);
  a16=1.4584230000000000e-04;
  a21=(a16*a06);
  a21=(a10+a21);
  a21=(a21*a19);
  a36=(a17*a21);
  a20=(a20+a36);
  a20=(a20*a34);
  if (res[0]!=0) res[0][4]=a20;
  a20=(a23*a19);
  a16=(a16*a05);
  a16=(a22+a16);
  a16=(a16*a19);
  a36=(a17*a16);
  a20=(a20+a36);
  a20=(a20*a34);
  a20=(-a20);
  if (res[0]!=0) res[0][5]=a20;
  a20=arg[2]? arg[2][2] : 0;
  a20=(a20*a19);
  a36=(a17*a20);
  a36=(a36*a34);
  a36=(-a36);
  if (res[0]!=0) res[0][6]=a36;
  a36=arg[2]? arg[2][1] : 0;
  a36=(a36*a19);
  a37=(a17*a36);
  a37=(a37*a34);
  if (res[0]!=0) res[0][7]=a37;
  a37=(a25*a13);
  a09=(a18*a25);
  a37=(a37+a09);
  a09=(a03*a24);
  a37=(a37-a09);
  a37=(a37*a34);
  a37=(a37-a25);
  if (res[0]!=0) res[0][8]=a37;
  a37=(a00-a18);
  a09=(a18*a18);
  a09=(a09-a26);
  a26=(a03*a01);
  a09=(a09-a26);
  a31=(a31*a19);
  a38=(a11*a31);
  a09=(a09-a38);
  a09=(a09*a34);
  a37=(a37+a09);
  if (res[0]!=0) res[0][9]=a37;
  a37=(a25*a23);
  a09=(a18*a03);
  a37=(a37+a09);
  a37=(a37*a34);
  a37=(a37-a03);
  if (res[0]!=0) res[0][10]=a37;
  a37=(a25*a17);
  a09=(a11*a21);
  a37=(a37+a09);
  a37=(a37*a34);
  a37=(-a37);
  if (res[0]!=0) res[0][11]=a37;
  a37=(a18*a11);
  a37=(a37*a34);
  a37=(a11-a37);
  if (res[0]!=0) res[0][12]=a37;
  a37=(a03*a19);
  a37=(-a37);
  if (res[0]!=0) res[0][13]=a37;
  a37=(a11*a20);
  a37=(a37*a34);
  if (res[0]!=0) res[0][14]=a37;
  a37=arg[2]? arg[2][0] : 0;
  a37=(a37*a19);
  a09=(a11*a37);
  a09=(a09*a34);
  a09=(-a09);
  if (res[0]!=0) res[0][15]=a09;
  a09=(a24*a13);
  a39=(a01*a25);
  a09=(a09+a39);
  a09=(a09*a34);
  a09=(a24-a09);
  if (res[0]!=0) res[0][16]=a09;
  a09=(a24*a14);
  a39=(a01*a18);
  a09=(a09-a39);
  a39=4.2053793008804680e-09;
  a40=(a35*a30);
  a40=(a40*a02);
  a39=(a39*a40);
  a35=(a35*a28);
  a35=(a35*a15);
  a15=3.8637053131731361e-03;
  a28=1.2932555768154467e-05;
  a28=(a28*a07);
  a04=(a04+a28);
  a04=(a04/a08);
  a15=(a15+a04);
  a35=(a35*a15);
  a29=(a29*a35);
  a39=(a39+a29);
  a39=(a39*a19);
  a29=(a19*a39);
  a09=(a09-a29);
  a09=(a09*a34);
  a09=(a01+a09);
  if (res[0]!=0) res[0][17]=a09;
  a27=(a27+a26);
  a09=1.4749033545883991e-13;
  a09=(a09*a02);
  a02=2.1026896504402340e-09;
  a02=(a02*a07);
  a09=(a09+a02);
  a02=3.1570428705798834e-07;
  a09=(a09-a02);
  a30=(a30*a09);
  a30=(a30*a19);
  a09=(a19*a30);
  a27=(a27+a09);
  a27=(a27*a34);
  a27=(a00-a27);
  if (res[0]!=0) res[0][18]=a27;
  a17=(a24*a17);
  a27=(a19*a16);
  a17=(a17+a27);
  a17=(a17*a34);
  if (res[0]!=0) res[0][19]=a17;
  a17=(a01*a11);
  if (res[0]!=0) res[0][20]=a17;
  if (res[0]!=0) res[0][21]=a19;
  a17=(a19*a36);
  a17=(a17*a34);
  a17=(-a17);
  if (res[0]!=0) res[0][22]=a17;
  a17=(a19*a37);
  a17=(a17*a34);
  if (res[0]!=0) res[0][23]=a17;
  a13=(a32*a13);
  a13=(a13*a34);
  a13=(a13-a32);
  if (res[0]!=0) res[0][24]=a13;
  a13=(a16*a39);
  a14=(a32*a14);
  a17=(a21*a31);
  a14=(a14+a17);
  a13=(a13-a14);
  a13=(a13*a34);
  if (res[0]!=0) res[0][25]=a13;
  a23=(a32*a23);
  a13=(a16*a30);
  a23=(a23+a13);
  a23=(a23*a34);
  if (res[0]!=0) res[0][26]=a23;
  a23=(a21*a21);
  a33=(a33+a23);
  a13=(a16*a16);
  a33=(a33+a13);
  a33=(a33*a34);
  a33=(a00-a33);
  if (res[0]!=0) res[0][27]=a33;
  a12=(a12*a19);
  a33=(a12*a16);
  a33=(a33*a34);
  a14=(a21-a33);
  if (res[0]!=0) res[0][28]=a14;
  a14=(a12*a21);
  a14=(a14*a34);
  a17=(a16+a14);
  a17=(-a17);
  if (res[0]!=0) res[0][29]=a17;
  a17=(a21*a20);
  a27=(a16*a36);
  a02=(a17+a27);
  a07=7.2921149999999999e-05;
  a06=(a07*a06);
  a10=(a10+a06);
  a10=(a10*a19);
  a06=(a20*a10);
  a02=(a02+a06);
  a07=(a07*a05);
  a22=(a22+a07);
  a22=(a22*a19);
  a19=(a36*a22);
  a02=(a02+a19);
  a02=(a02*a34);
  if (res[0]!=0) res[0][30]=a02;
  a02=(a12*a36);
  a07=(a16*a37);
  a07=(a02-a07);
  a07=(a07*a34);
  a07=(a07-a20);
  if (res[0]!=0) res[0][31]=a07;
  a07=(a12*a20);
  a05=(a21*a37);
  a05=(a07-a05);
  a05=(a05*a34);
  a05=(a36+a05);
  if (res[0]!=0) res[0][32]=a05;
  a05=(a31*a25);
  a29=(a21*a32);
  a05=(a05+a29);
  a05=(a05*a34);
  if (res[0]!=0) res[0][33]=a05;
  a05=(a31*a18);
  a29=(a12*a39);
  a05=(a05+a29);
  a05=(a05*a34);
  a05=(a05-a31);
  if (res[0]!=0) res[0][34]=a05;
  a05=(a31*a03);
  a29=(a12*a30);
  a05=(a05+a29);
  a05=(a05*a34);
  if (res[0]!=0) res[0][35]=a05;
  a33=(a21+a33);
  a33=(-a33);
  if (res[0]!=0) res[0][36]=a33;
  a38=(a38+a23);
  a38=(a38+a26);
  a38=(a38*a34);
  a38=(a00-a38);
  if (res[0]!=0) res[0][37]=a38;
  a38=(a16*a21);
  a23=(a38*a34);
  a23=(a23-a12);
  if (res[0]!=0) res[0][38]=a23;
  a23=(a37*a22);
  a02=(a02-a23);
  a02=(a02*a34);
  a02=(a20+a02);
  if (res[0]!=0) res[0][39]=a02;
  a02=(a12*a37);
  a17=(a17-a02);
  a17=(a17+a06);
  a17=(a17-a02);
  a17=(a17*a34);
  if (res[0]!=0) res[0][40]=a17;
  a21=(a21*a36);
  a17=(a20*a22);
  a21=(a21+a17);
  a21=(a21*a34);
  a21=(a37+a21);
  a21=(-a21);
  if (res[0]!=0) res[0][41]=a21;
  a25=(a39*a25);
  a24=(a30*a24);
  a25=(a25-a24);
  a32=(a16*a32);
  a25=(a25-a32);
  a25=(a25*a34);
  if (res[0]!=0) res[0][42]=a25;
  a18=(a39*a18);
  a01=(a30*a01);
  a18=(a18-a01);
  a31=(a12*a31);
  a18=(a18-a31);
  a18=(a18*a34);
  a18=(a18-a39);
  if (res[0]!=0) res[0][43]=a18;
  a03=(a39*a03);
  a03=(a03*a34);
  a03=(a03-a30);
  if (res[0]!=0) res[0][44]=a03;
  a14=(a16-a14);
  if (res[0]!=0) res[0][45]=a14;
  a39=(a39*a11);
  a38=(a38-a39);
  a38=(a38*a34);
  a38=(a12+a38);
  if (res[0]!=0) res[0][46]=a38;
  a09=(a09+a13);
  a09=(a09+a26);
  a09=(a09*a34);
  a09=(a00-a09);
  if (res[0]!=0) res[0][47]=a09;
  a09=(a37*a10);
  a07=(a07-a09);
  a07=(a07*a34);
  a07=(a07-a36);
  if (res[0]!=0) res[0][48]=a07;
  a16=(a16*a20);
  a36=(a36*a10);
  a16=(a16+a36);
  a16=(a16*a34);
  a37=(a37-a16);
  if (res[0]!=0) res[0][49]=a37;
  a27=(a27-a02);
  a27=(a27+a19);
  a27=(a27-a02);
  a27=(a27*a34);
  if (res[0]!=0) res[0][50]=a27;
  a27=(a10*a10);
  a02=(a22*a22);
  a19=(a27+a02);
  a19=(a19*a34);
  a19=(a00-a19);
  if (res[0]!=0) res[0][51]=a19;
  a19=(a12*a22);
  a19=(a19*a34);
  a37=(a10-a19);
  if (res[0]!=0) res[0][52]=a37;
  a37=(a12*a10);
  a37=(a37*a34);
  a16=(a22+a37);
  a16=(-a16);
  if (res[0]!=0) res[0][53]=a16;
  a19=(a10+a19);
  a19=(-a19);
  if (res[0]!=0) res[0][54]=a19;
  a27=(a27+a26);
  a27=(a27*a34);
  a27=(a00-a27);
  if (res[0]!=0) res[0][55]=a27;
  a10=(a22*a10);
  a10=(a10*a34);
  a27=(a10-a12);
  if (res[0]!=0) res[0][56]=a27;
  a22=(a22-a37);
  if (res[0]!=0) res[0][57]=a22;
  a12=(a12+a10);
  if (res[0]!=0) res[0][58]=a12;
  a02=(a02+a26);
  a02=(a02*a34);
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


