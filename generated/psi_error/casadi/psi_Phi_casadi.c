/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) psi_Phi_casadi__ ## ID
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

/* psi_Phi_casadi:(position[3],v_n[3],f_n[3],dt)->(out_Phi[60]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36;
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
  a26=(a23*a24);
  a21=(a21-a26);
  a17=(a17*a16);
  a17=(a17*a19);
  a26=7.3745167729419953e-14;
  a27=(a02*a02);
  a26=(a26*a27);
  a26=(a00+a26);
  a27=1.5678559428873979e-07;
  a28=2.0136051943431768e+00;
  a29=1.3411242658989924e-02;
  a29=(a29*a07);
  a28=(a28-a29);
  a28=(a02*a28);
  a27=(a27*a28);
  a26=(a26-a27);
  a27=9.7803253359000006e+00;
  a28=1.8894147482439335e-02;
  a28=(a28*a07);
  a28=(a27+a28);
  a28=(a28*a15);
  a29=(a26*a28);
  a30=(a29*a05);
  a30=(a30*a19);
  a31=(a17*a30);
  a21=(a21-a31);
  a31=5.0000000000000000e-01;
  a21=(a21*a31);
  a20=(a20+a21);
  if (res[0]!=0) res[0][0]=a20;
  a20=(a13*a14);
  a18=(a18*a11);
  a21=1.2723551478415026e+05;
  a03=(a03*a03);
  a03=(a01/a03);
  a32=(a06*a05);
  a33=(a03*a32);
  a34=(a08*a08);
  a34=(a34*a09);
  a33=(a33/a34);
  a21=(a21*a33);
  a18=(a18+a21);
  a18=(a18*a19);
  a21=(a14*a18);
  a20=(a20+a21);
  a01=(a01*a19);
  a21=(a23*a01);
  a20=(a20+a21);
  a20=(a20*a31);
  a20=(a14-a20);
  if (res[0]!=0) res[0][1]=a20;
  a20=(a13*a23);
  a03=(a03*a19);
  a21=(a14*a03);
  a20=(a20-a21);
  a20=(a20*a31);
  a20=(a20-a23);
  if (res[0]!=0) res[0][2]=a20;
  a20=(a13*a17);
  a20=(a20*a31);
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
  a33=(a17*a21);
  a20=(a20+a33);
  a20=(a20*a31);
  if (res[0]!=0) res[0][4]=a20;
  a20=(a23*a19);
  a16=(a16*a05);
  a16=(a22+a16);
  a16=(a16*a19);
  a33=(a17*a16);
  a20=(a20+a33);
  a20=(a20*a31);
  a20=(-a20);
  if (res[0]!=0) res[0][5]=a20;
  a20=arg[2]? arg[2][2] : 0;
  a20=(a20*a19);
  a33=(a17*a20);
  a33=(a33*a31);
  a33=(-a33);
  if (res[0]!=0) res[0][6]=a33;
  a33=arg[2]? arg[2][1] : 0;
  a33=(a33*a19);
  a34=(a17*a33);
  a34=(a34*a31);
  if (res[0]!=0) res[0][7]=a34;
  a34=(a25*a13);
  a09=(a18*a25);
  a34=(a34+a09);
  a09=(a03*a24);
  a34=(a34-a09);
  a34=(a34*a31);
  a34=(a34-a25);
  if (res[0]!=0) res[0][8]=a34;
  a34=(a00-a18);
  a09=(a18*a18);
  a35=(a25*a14);
  a09=(a09-a35);
  a35=(a03*a01);
  a09=(a09-a35);
  a29=(a29*a19);
  a35=(a11*a29);
  a09=(a09-a35);
  a09=(a09*a31);
  a34=(a34+a09);
  if (res[0]!=0) res[0][9]=a34;
  a34=(a25*a23);
  a09=(a18*a03);
  a34=(a34+a09);
  a34=(a34*a31);
  a34=(a34-a03);
  if (res[0]!=0) res[0][10]=a34;
  a34=(a25*a17);
  a09=(a11*a21);
  a34=(a34+a09);
  a34=(a34*a31);
  a34=(-a34);
  if (res[0]!=0) res[0][11]=a34;
  a34=(a18*a11);
  a34=(a34*a31);
  a34=(a11-a34);
  if (res[0]!=0) res[0][12]=a34;
  a34=(a03*a19);
  a12=(a12*a19);
  a09=(a11*a12);
  a34=(a34+a09);
  a34=(a34*a31);
  a34=(-a34);
  if (res[0]!=0) res[0][13]=a34;
  a34=(a11*a20);
  a34=(a34*a31);
  if (res[0]!=0) res[0][14]=a34;
  a34=arg[2]? arg[2][0] : 0;
  a34=(a34*a19);
  a09=(a11*a34);
  a09=(a09*a31);
  a09=(-a09);
  if (res[0]!=0) res[0][15]=a09;
  a09=(a24*a13);
  a35=(a01*a25);
  a09=(a09+a35);
  a09=(a09*a31);
  a09=(a24-a09);
  if (res[0]!=0) res[0][16]=a09;
  a09=(a24*a14);
  a35=(a01*a18);
  a09=(a09-a35);
  a35=4.2053793008804680e-09;
  a36=(a32*a28);
  a36=(a36*a02);
  a35=(a35*a36);
  a32=(a32*a26);
  a32=(a32*a15);
  a15=3.8637053131731361e-03;
  a26=1.2932555768154467e-05;
  a26=(a26*a07);
  a04=(a04+a26);
  a04=(a04/a08);
  a15=(a15+a04);
  a32=(a32*a15);
  a27=(a27*a32);
  a35=(a35+a27);
  a35=(a35*a19);
  a27=(a19*a35);
  a09=(a09-a27);
  a09=(a09*a31);
  a09=(a01+a09);
  if (res[0]!=0) res[0][17]=a09;
  a09=(a24*a23);
  a27=(a01*a03);
  a09=(a09+a27);
  a27=1.4749033545883991e-13;
  a27=(a27*a02);
  a02=2.1026896504402340e-09;
  a02=(a02*a07);
  a27=(a27+a02);
  a02=3.1570428705798834e-07;
  a27=(a27-a02);
  a28=(a28*a27);
  a28=(a28*a19);
  a27=(a19*a28);
  a09=(a09+a27);
  a09=(a09*a31);
  a09=(a00-a09);
  if (res[0]!=0) res[0][18]=a09;
  a09=(a24*a17);
  a27=(a19*a16);
  a09=(a09+a27);
  a09=(a09*a31);
  if (res[0]!=0) res[0][19]=a09;
  a09=(a01*a11);
  a27=(a19*a12);
  a09=(a09+a27);
  a09=(a09*a31);
  if (res[0]!=0) res[0][20]=a09;
  if (res[0]!=0) res[0][21]=a19;
  a09=(a19*a33);
  a09=(a09*a31);
  a09=(-a09);
  if (res[0]!=0) res[0][22]=a09;
  a09=(a19*a34);
  a09=(a09*a31);
  if (res[0]!=0) res[0][23]=a09;
  a13=(a30*a13);
  a13=(a13*a31);
  a13=(a13-a30);
  if (res[0]!=0) res[0][24]=a13;
  a13=(a16*a35);
  a14=(a30*a14);
  a09=(a21*a29);
  a14=(a14+a09);
  a13=(a13-a14);
  a13=(a13*a31);
  if (res[0]!=0) res[0][25]=a13;
  a23=(a30*a23);
  a13=(a16*a28);
  a23=(a23+a13);
  a23=(a23*a31);
  if (res[0]!=0) res[0][26]=a23;
  a17=(a30*a17);
  a23=(a21*a21);
  a17=(a17+a23);
  a13=(a16*a16);
  a17=(a17+a13);
  a17=(a17*a31);
  a17=(a00-a17);
  if (res[0]!=0) res[0][27]=a17;
  a17=(a16*a12);
  a17=(a17*a31);
  a17=(a21-a17);
  if (res[0]!=0) res[0][28]=a17;
  a17=(a21*a12);
  a17=(a17*a31);
  a17=(a16+a17);
  a17=(-a17);
  if (res[0]!=0) res[0][29]=a17;
  a17=(a21*a20);
  a14=(a16*a33);
  a09=(a17+a14);
  a27=7.2921149999999999e-05;
  a06=(a27*a06);
  a10=(a10+a06);
  a10=(a10*a19);
  a06=(a20*a10);
  a09=(a09+a06);
  a27=(a27*a05);
  a22=(a22+a27);
  a22=(a22*a19);
  a27=(a33*a22);
  a09=(a09+a27);
  a09=(a09*a31);
  if (res[0]!=0) res[0][30]=a09;
  a09=(a33*a12);
  a05=(a16*a34);
  a09=(a09-a05);
  a09=(a09*a31);
  a09=(a09-a20);
  if (res[0]!=0) res[0][31]=a09;
  a09=(a20*a12);
  a05=(a21*a34);
  a09=(a09-a05);
  a09=(a09*a31);
  a09=(a33+a09);
  if (res[0]!=0) res[0][32]=a09;
  a09=(a29*a25);
  a05=(a21*a30);
  a09=(a09+a05);
  a09=(a09*a31);
  if (res[0]!=0) res[0][33]=a09;
  a09=(a29*a18);
  a05=(a12*a35);
  a09=(a09+a05);
  a09=(a09*a31);
  a09=(a09-a29);
  if (res[0]!=0) res[0][34]=a09;
  a09=(a29*a03);
  a05=(a12*a28);
  a09=(a09+a05);
  a09=(a09*a31);
  if (res[0]!=0) res[0][35]=a09;
  a09=(a12*a16);
  a09=(a09*a31);
  a09=(a21+a09);
  a09=(-a09);
  if (res[0]!=0) res[0][36]=a09;
  a09=(a29*a11);
  a09=(a09+a23);
  a23=(a12*a12);
  a09=(a09+a23);
  a09=(a09*a31);
  a09=(a00-a09);
  if (res[0]!=0) res[0][37]=a09;
  a09=(a21*a16);
  a09=(a09*a31);
  a09=(a09-a12);
  if (res[0]!=0) res[0][38]=a09;
  a09=(a12*a33);
  a05=(a34*a22);
  a09=(a09-a05);
  a09=(a09*a31);
  a09=(a20+a09);
  if (res[0]!=0) res[0][39]=a09;
  a09=(a12*a34);
  a17=(a17-a09);
  a17=(a17+a06);
  a06=(a34*a12);
  a17=(a17-a06);
  a17=(a17*a31);
  if (res[0]!=0) res[0][40]=a17;
  a17=(a21*a33);
  a05=(a20*a22);
  a17=(a17+a05);
  a17=(a17*a31);
  a17=(a34+a17);
  a17=(-a17);
  if (res[0]!=0) res[0][41]=a17;
  a25=(a35*a25);
  a24=(a28*a24);
  a25=(a25-a24);
  a30=(a16*a30);
  a25=(a25-a30);
  a25=(a25*a31);
  if (res[0]!=0) res[0][42]=a25;
  a18=(a35*a18);
  a01=(a28*a01);
  a18=(a18-a01);
  a29=(a12*a29);
  a18=(a18-a29);
  a18=(a18*a31);
  a18=(a18-a35);
  if (res[0]!=0) res[0][43]=a18;
  a03=(a35*a03);
  a03=(a03*a31);
  a03=(a03-a28);
  if (res[0]!=0) res[0][44]=a03;
  a03=(a12*a21);
  a03=(a03*a31);
  a03=(a16-a03);
  if (res[0]!=0) res[0][45]=a03;
  a21=(a16*a21);
  a35=(a35*a11);
  a21=(a21-a35);
  a21=(a21*a31);
  a21=(a12+a21);
  if (res[0]!=0) res[0][46]=a21;
  a28=(a28*a19);
  a28=(a28+a13);
  a28=(a28+a23);
  a28=(a28*a31);
  a28=(a00-a28);
  if (res[0]!=0) res[0][47]=a28;
  a28=(a12*a20);
  a13=(a34*a10);
  a28=(a28-a13);
  a28=(a28*a31);
  a28=(a28-a33);
  if (res[0]!=0) res[0][48]=a28;
  a16=(a16*a20);
  a33=(a33*a10);
  a16=(a16+a33);
  a16=(a16*a31);
  a34=(a34-a16);
  if (res[0]!=0) res[0][49]=a34;
  a14=(a14-a09);
  a14=(a14+a27);
  a14=(a14-a06);
  a14=(a14*a31);
  if (res[0]!=0) res[0][50]=a14;
  a14=(a10*a10);
  a06=(a22*a22);
  a27=(a14+a06);
  a27=(a27*a31);
  a27=(a00-a27);
  if (res[0]!=0) res[0][51]=a27;
  a27=(a22*a12);
  a27=(a27*a31);
  a27=(a10-a27);
  if (res[0]!=0) res[0][52]=a27;
  a27=(a10*a12);
  a27=(a27*a31);
  a27=(a22+a27);
  a27=(-a27);
  if (res[0]!=0) res[0][53]=a27;
  a27=(a12*a22);
  a27=(a27*a31);
  a27=(a10+a27);
  a27=(-a27);
  if (res[0]!=0) res[0][54]=a27;
  a14=(a14+a23);
  a14=(a14*a31);
  a14=(a00-a14);
  if (res[0]!=0) res[0][55]=a14;
  a14=(a10*a22);
  a14=(a14*a31);
  a14=(a14-a12);
  if (res[0]!=0) res[0][56]=a14;
  a14=(a12*a10);
  a14=(a14*a31);
  a14=(a22-a14);
  if (res[0]!=0) res[0][57]=a14;
  a22=(a22*a10);
  a22=(a22*a31);
  a12=(a12+a22);
  if (res[0]!=0) res[0][58]=a12;
  a06=(a06+a23);
  a06=(a06*a31);
  a00=(a00-a06);
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
    case 0: return "position";
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


