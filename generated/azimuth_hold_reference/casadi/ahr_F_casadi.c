/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) ahr_F_casadi__ ## ID
#endif

#include <math.h>
#include "../src/ahr_math.h"
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
CASADI_SYMBOL_EXPORT void ahr_F_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int ahr_F_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int ahr_F_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {60, 1, 1};

/* ahr_F_casadi:(lon_lat_height[3],v_n[3],q_b2n_wxyz[4],f_b[3])->(out_F[60]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48;
  a00=1.;
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
  a15=(-a15);
  if (res[0]!=0) res[0][0]=a15;
  a10=(a10*a10);
  a10=(a14/a10);
  a12=(a10*a12);
  a12=(-a12);
  if (res[0]!=0) res[0][1]=a12;
  if (res[0]!=0) res[0][2]=a13;
  a13=arg[1]? arg[1][1] : 0;
  a12=6.3354393272928204e+06;
  a07=(a07*a08);
  a12=(a12/a07);
  a07=(a01+a12);
  a08=(a07*a07);
  a08=(a13/a08);
  a15=2.0083139970423949e-02;
  a18=(a18*a12);
  a15=(a15*a18);
  a15=(a08*a15);
  a18=(-a15);
  if (res[0]!=0) res[0][3]=a18;
  a18=(-a08);
  if (res[0]!=0) res[0][4]=a18;
  a07=(a00/a07);
  if (res[0]!=0) res[0][5]=a07;
  if (res[0]!=0) res[0][6]=a00;
  a18=1.4584230000000000e-04;
  a12=(a18*a04);
  a19=(a14*a11);
  a21=(a04*a04);
  a21=(a19/a21);
  a02=(a10*a02);
  a22=(a20*a02);
  a21=(a21-a22);
  a22=(a12+a21);
  a23=(a22*a13);
  a18=(a18*a05);
  a24=(a02+a18);
  a25=arg[1]? arg[1][2] : 0;
  a26=(a24*a25);
  a23=(a23+a26);
  if (res[0]!=0) res[0][7]=a23;
  a23=(a25*a10);
  a26=(a20*a10);
  a27=(a13*a26);
  a23=(a23-a27);
  if (res[0]!=0) res[0][8]=a23;
  a20=(a20*a11);
  a23=(a13*a20);
  a27=(a25*a11);
  a23=(a23-a27);
  if (res[0]!=0) res[0][9]=a23;
  a23=(a20*a14);
  a18=(a18+a23);
  if (res[0]!=0) res[0][10]=a18;
  a12=(a12+a19);
  a27=(-a12);
  if (res[0]!=0) res[0][11]=a27;
  a27=arg[3]? arg[3][0] : 0;
  a28=2.;
  a29=arg[2]? arg[2][1] : 0;
  a30=(a28*a29);
  a31=arg[2]? arg[2][3] : 0;
  a32=(a30*a31);
  a33=arg[2]? arg[2][0] : 0;
  a34=(a28*a33);
  a35=arg[2]? arg[2][2] : 0;
  a36=(a34*a35);
  a37=(a32-a36);
  a38=(a27*a37);
  a39=arg[3]? arg[3][1] : 0;
  a40=(a34*a29);
  a41=(a28*a31);
  a41=(a41*a35);
  a42=(a40+a41);
  a43=(a39*a42);
  a38=(a38+a43);
  a43=arg[3]? arg[3][2] : 0;
  a44=(a31*a31);
  a45=(a35*a35);
  a46=(a44-a45);
  a33=(a33*a33);
  a29=(a29*a29);
  a47=(a33-a29);
  a46=(a46+a47);
  a48=(a43*a46);
  a38=(a38+a48);
  a48=(-a38);
  if (res[0]!=0) res[0][12]=a48;
  a34=(a34*a31);
  a30=(a30*a35);
  a35=(a34+a30);
  a31=(a27*a35);
  a47=(a45+a47);
  a47=(a47-a44);
  a48=(a39*a47);
  a31=(a31+a48);
  a41=(a41-a40);
  a40=(a43*a41);
  a31=(a31+a40);
  if (res[0]!=0) res[0][13]=a31;
  a33=(a33-a45);
  a33=(a33+a29);
  a33=(a33-a44);
  a44=(-a33);
  if (res[0]!=0) res[0][14]=a44;
  a30=(a30-a34);
  a34=(-a30);
  if (res[0]!=0) res[0][15]=a34;
  a36=(a36+a32);
  a32=(-a36);
  if (res[0]!=0) res[0][16]=a32;
  a32=(a25*a15);
  a22=(a22*a14);
  a32=(a32-a22);
  if (res[0]!=0) res[0][17]=a32;
  a32=(a25*a08);
  a22=(a14*a26);
  a32=(a32+a22);
  if (res[0]!=0) res[0][18]=a32;
  a18=(a18+a23);
  a18=(-a18);
  if (res[0]!=0) res[0][19]=a18;
  a25=(a25*a07);
  a25=(-a25);
  if (res[0]!=0) res[0][20]=a25;
  a25=(a13*a07);
  a18=(-a25);
  if (res[0]!=0) res[0][21]=a18;
  if (res[0]!=0) res[0][22]=a38;
  a27=(a27*a33);
  a39=(a39*a30);
  a27=(a27+a39);
  a43=(a43*a36);
  a27=(a27+a43);
  a43=(-a27);
  if (res[0]!=0) res[0][23]=a43;
  a43=(-a35);
  if (res[0]!=0) res[0][24]=a43;
  a43=(-a47);
  if (res[0]!=0) res[0][25]=a43;
  a43=(-a41);
  if (res[0]!=0) res[0][26]=a43;
  a24=(a24*a14);
  a43=4.2053793008804680e-09;
  a39=(a16*a01);
  a38=9.7803253359000006e+00;
  a32=1.8894147482439335e-02;
  a32=(a32*a06);
  a32=(a38+a32);
  a32=(a32*a09);
  a39=(a39*a32);
  a43=(a43*a39);
  a16=(a16*a09);
  a09=3.8637053131731361e-03;
  a39=1.2932555768154467e-05;
  a39=(a39*a06);
  a03=(a03+a39);
  a03=(a03*a17);
  a09=(a09+a03);
  a16=(a16*a09);
  a09=7.3745167729419953e-14;
  a03=(a01*a01);
  a09=(a09*a03);
  a00=(a00+a09);
  a09=1.5678559428873979e-07;
  a03=2.0136051943431768e+00;
  a17=1.3411242658989924e-02;
  a17=(a17*a06);
  a03=(a03-a17);
  a03=(a01*a03);
  a09=(a09*a03);
  a00=(a00-a09);
  a16=(a16*a00);
  a38=(a38*a16);
  a43=(a43+a38);
  a24=(a24+a43);
  a43=(a13*a15);
  a24=(a24+a43);
  a24=(-a24);
  if (res[0]!=0) res[0][27]=a24;
  a14=(a14*a10);
  a24=1.4749033545883991e-13;
  a24=(a24*a01);
  a01=2.1026896504402340e-09;
  a01=(a01*a06);
  a24=(a24+a01);
  a01=3.1570428705798834e-07;
  a24=(a24-a01);
  a24=(a24*a32);
  a14=(a14+a24);
  a13=(a13*a08);
  a14=(a14+a13);
  a14=(-a14);
  if (res[0]!=0) res[0][28]=a14;
  a12=(a19+a12);
  if (res[0]!=0) res[0][29]=a12;
  a28=(a28*a25);
  if (res[0]!=0) res[0][30]=a28;
  a31=(-a31);
  if (res[0]!=0) res[0][31]=a31;
  if (res[0]!=0) res[0][32]=a27;
  a27=(-a37);
  if (res[0]!=0) res[0][33]=a27;
  a27=(-a42);
  if (res[0]!=0) res[0][34]=a27;
  a27=(-a46);
  if (res[0]!=0) res[0][35]=a27;
  if (res[0]!=0) res[0][36]=a15;
  if (res[0]!=0) res[0][37]=a08;
  a07=(-a07);
  if (res[0]!=0) res[0][38]=a07;
  a07=7.2921149999999999e-05;
  a05=(a07*a05);
  a23=(a23+a05);
  if (res[0]!=0) res[0][39]=a23;
  a07=(a07*a04);
  a19=(a19+a07);
  a04=(-a19);
  if (res[0]!=0) res[0][40]=a04;
  if (res[0]!=0) res[0][41]=a33;
  if (res[0]!=0) res[0][42]=a30;
  if (res[0]!=0) res[0][43]=a36;
  a02=(a02+a05);
  a02=(-a02);
  if (res[0]!=0) res[0][44]=a02;
  a10=(-a10);
  if (res[0]!=0) res[0][45]=a10;
  if (res[0]!=0) res[0][46]=a11;
  a23=(-a23);
  if (res[0]!=0) res[0][47]=a23;
  if (res[0]!=0) res[0][48]=a18;
  if (res[0]!=0) res[0][49]=a35;
  if (res[0]!=0) res[0][50]=a47;
  if (res[0]!=0) res[0][51]=a41;
  a07=(a07+a21);
  if (res[0]!=0) res[0][52]=a07;
  a26=(-a26);
  if (res[0]!=0) res[0][53]=a26;
  if (res[0]!=0) res[0][54]=a20;
  if (res[0]!=0) res[0][55]=a19;
  if (res[0]!=0) res[0][56]=a25;
  if (res[0]!=0) res[0][57]=a37;
  if (res[0]!=0) res[0][58]=a42;
  if (res[0]!=0) res[0][59]=a46;
  return 0;
}

CASADI_SYMBOL_EXPORT int ahr_F_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ahr_F_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ahr_F_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ahr_F_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void ahr_F_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ahr_F_casadi_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int ahr_F_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real ahr_F_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ahr_F_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "f_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ahr_F_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_F";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ahr_F_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ahr_F_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ahr_F_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ahr_F_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


