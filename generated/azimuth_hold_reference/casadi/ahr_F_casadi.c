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
  casadi_real a48, a49, a50, a51, a52, a53, a54;
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
  a02=(a01+a02);
  a10=(a00/a02);
  a04=cos(a04);
  a11=(a00/a04);
  a12=(a10*a11);
  a13=arg[1]? arg[1][0] : 0;
  a14=(a12*a13);
  a15=4.2697672707179969e+04;
  a16=(a05*a04);
  a17=(a07*a08);
  a17=(a00/a17);
  a18=(a16*a17);
  a19=(a18*a10);
  a19=(a15*a19);
  a20=(a05*a11);
  a19=(a19-a20);
  a14=(a14*a19);
  a14=(-a14);
  if (res[0]!=0) res[0][0]=a14;
  a02=(a02*a02);
  a02=(a00/a02);
  a14=(a13*a02);
  a11=(a14*a11);
  a11=(-a11);
  if (res[0]!=0) res[0][1]=a11;
  if (res[0]!=0) res[0][2]=a12;
  a12=arg[1]? arg[1][1] : 0;
  a11=6.3354393272928204e+06;
  a11=(a11*a17);
  a11=(a01+a11);
  a17=(a11*a11);
  a17=(a00/a17);
  a19=(a12*a17);
  a21=1.2723551478415026e+05;
  a22=(a07*a07);
  a22=(a22*a08);
  a22=(a00/a22);
  a08=(a16*a22);
  a08=(a21*a08);
  a23=(a19*a08);
  a24=(-a23);
  if (res[0]!=0) res[0][3]=a24;
  a24=(-a19);
  if (res[0]!=0) res[0][4]=a24;
  a11=(a00/a11);
  if (res[0]!=0) res[0][5]=a11;
  if (res[0]!=0) res[0][6]=a00;
  a24=1.4584230000000000e-04;
  a25=(a24*a04);
  a26=(a13*a10);
  a27=(a04*a04);
  a27=(a26/a27);
  a15=(a15*a18);
  a18=(a20*a14);
  a28=(a15*a18);
  a27=(a27-a28);
  a28=(a25+a27);
  a29=(a28*a12);
  a24=(a24*a05);
  a15=(a14*a15);
  a30=(a24+a15);
  a31=arg[1]? arg[1][2] : 0;
  a32=(a30*a31);
  a29=(a29+a32);
  if (res[0]!=0) res[0][7]=a29;
  a29=(a14*a31);
  a32=(a18*a12);
  a29=(a29-a32);
  if (res[0]!=0) res[0][8]=a29;
  a29=(a20*a10);
  a32=(a29*a12);
  a33=(a31*a10);
  a32=(a32-a33);
  if (res[0]!=0) res[0][9]=a32;
  a32=(a20*a26);
  a33=(a24+a32);
  if (res[0]!=0) res[0][10]=a33;
  a33=(a25+a26);
  a33=(-a33);
  if (res[0]!=0) res[0][11]=a33;
  a33=2.;
  a34=arg[2]? arg[2][0] : 0;
  a35=(a33*a34);
  a36=arg[2]? arg[2][1] : 0;
  a37=(a35*a36);
  a38=arg[2]? arg[2][3] : 0;
  a39=(a33*a38);
  a40=arg[2]? arg[2][2] : 0;
  a41=(a39*a40);
  a42=(a37+a41);
  a43=arg[3]? arg[3][1] : 0;
  a44=(a42*a43);
  a45=(a35*a40);
  a39=(a39*a36);
  a46=(a45-a39);
  a47=arg[3]? arg[3][0] : 0;
  a48=(a46*a47);
  a44=(a44-a48);
  a48=(a38*a38);
  a49=(a40*a40);
  a50=(a48-a49);
  a34=(a34*a34);
  a51=(a36*a36);
  a52=(a34-a51);
  a50=(a50+a52);
  a53=arg[3]? arg[3][2] : 0;
  a54=(a50*a53);
  a44=(a44+a54);
  a54=(-a44);
  if (res[0]!=0) res[0][12]=a54;
  a35=(a35*a38);
  a36=(a36*a40);
  a36=(a33*a36);
  a40=(a35+a36);
  a38=(a40*a47);
  a37=(a37-a41);
  a41=(a37*a53);
  a38=(a38-a41);
  a52=(a49+a52);
  a52=(a52-a48);
  a41=(a52*a43);
  a38=(a38+a41);
  if (res[0]!=0) res[0][13]=a38;
  a34=(a34-a49);
  a34=(a34+a51);
  a34=(a34-a48);
  a48=(-a34);
  if (res[0]!=0) res[0][14]=a48;
  a35=(a35-a36);
  if (res[0]!=0) res[0][15]=a35;
  a45=(a45+a39);
  a39=(-a45);
  if (res[0]!=0) res[0][16]=a39;
  a39=(a05*a17);
  a39=(a39*a22);
  a39=(a39*a04);
  a39=(a39*a12);
  a39=(a39*a31);
  a21=(a21*a39);
  a28=(a28*a13);
  a21=(a21-a28);
  if (res[0]!=0) res[0][17]=a21;
  a21=(a13*a13);
  a21=(a21*a02);
  a20=(a20*a21);
  a02=(a19*a31);
  a20=(a20+a02);
  if (res[0]!=0) res[0][18]=a20;
  a20=(a33*a32);
  a24=(a24+a20);
  a24=(-a24);
  if (res[0]!=0) res[0][19]=a24;
  a31=(a31*a11);
  a31=(-a31);
  if (res[0]!=0) res[0][20]=a31;
  a31=(a12*a11);
  a24=(-a31);
  if (res[0]!=0) res[0][21]=a24;
  if (res[0]!=0) res[0][22]=a44;
  a47=(a34*a47);
  a53=(a45*a53);
  a47=(a47+a53);
  a43=(a35*a43);
  a47=(a47-a43);
  a43=(-a47);
  if (res[0]!=0) res[0][23]=a43;
  a43=(-a40);
  if (res[0]!=0) res[0][24]=a43;
  a43=(-a52);
  if (res[0]!=0) res[0][25]=a43;
  if (res[0]!=0) res[0][26]=a37;
  a30=(a30*a13);
  a12=(a12*a12);
  a12=(a12*a17);
  a08=(a08*a12);
  a30=(a30+a08);
  a08=4.2053793008804680e-09;
  a17=9.7803253359000006e+00;
  a13=1.8894147482439335e-02;
  a13=(a13*a06);
  a13=(a17+a13);
  a13=(a13*a09);
  a43=(a16*a13);
  a43=(a43*a01);
  a08=(a08*a43);
  a30=(a30+a08);
  a16=(a16*a09);
  a09=3.8637053131731361e-03;
  a08=1.2932555768154467e-05;
  a08=(a08*a06);
  a03=(a03+a08);
  a03=(a03/a07);
  a09=(a09+a03);
  a16=(a16*a09);
  a09=7.3745167729419953e-14;
  a03=(a01*a01);
  a09=(a09*a03);
  a00=(a00+a09);
  a09=1.5678559428873979e-07;
  a03=2.0136051943431768e+00;
  a07=1.3411242658989924e-02;
  a07=(a07*a06);
  a03=(a03-a07);
  a03=(a01*a03);
  a09=(a09*a03);
  a00=(a00-a09);
  a16=(a16*a00);
  a17=(a17*a16);
  a30=(a30+a17);
  a30=(-a30);
  if (res[0]!=0) res[0][27]=a30;
  a21=(a21+a12);
  a12=1.4749033545883991e-13;
  a12=(a12*a01);
  a01=2.1026896504402340e-09;
  a01=(a01*a06);
  a12=(a12+a01);
  a01=3.1570428705798834e-07;
  a12=(a12-a01);
  a13=(a13*a12);
  a21=(a21+a13);
  a21=(-a21);
  if (res[0]!=0) res[0][28]=a21;
  a21=(a33*a26);
  a25=(a25+a21);
  if (res[0]!=0) res[0][29]=a25;
  a33=(a33*a31);
  if (res[0]!=0) res[0][30]=a33;
  a38=(-a38);
  if (res[0]!=0) res[0][31]=a38;
  if (res[0]!=0) res[0][32]=a47;
  if (res[0]!=0) res[0][33]=a46;
  a47=(-a42);
  if (res[0]!=0) res[0][34]=a47;
  a47=(-a50);
  if (res[0]!=0) res[0][35]=a47;
  if (res[0]!=0) res[0][36]=a23;
  if (res[0]!=0) res[0][37]=a19;
  a11=(-a11);
  if (res[0]!=0) res[0][38]=a11;
  a11=7.2921149999999999e-05;
  a05=(a11*a05);
  a32=(a32+a05);
  if (res[0]!=0) res[0][39]=a32;
  a11=(a11*a04);
  a26=(a26+a11);
  a04=(-a26);
  if (res[0]!=0) res[0][40]=a04;
  if (res[0]!=0) res[0][41]=a34;
  a35=(-a35);
  if (res[0]!=0) res[0][42]=a35;
  if (res[0]!=0) res[0][43]=a45;
  a15=(a15+a05);
  a15=(-a15);
  if (res[0]!=0) res[0][44]=a15;
  a14=(-a14);
  if (res[0]!=0) res[0][45]=a14;
  if (res[0]!=0) res[0][46]=a10;
  a32=(-a32);
  if (res[0]!=0) res[0][47]=a32;
  if (res[0]!=0) res[0][48]=a24;
  if (res[0]!=0) res[0][49]=a40;
  if (res[0]!=0) res[0][50]=a52;
  a37=(-a37);
  if (res[0]!=0) res[0][51]=a37;
  a27=(a27+a11);
  if (res[0]!=0) res[0][52]=a27;
  a18=(-a18);
  if (res[0]!=0) res[0][53]=a18;
  if (res[0]!=0) res[0][54]=a29;
  if (res[0]!=0) res[0][55]=a26;
  if (res[0]!=0) res[0][56]=a31;
  a46=(-a46);
  if (res[0]!=0) res[0][57]=a46;
  if (res[0]!=0) res[0][58]=a42;
  if (res[0]!=0) res[0][59]=a50;
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


