/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_dcm_exact_z_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vd_dcm_exact_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};

/* vd_dcm_exact_z_casadi:(q_b2n_wxyz[4],mu[3],q_r2n_wxyz[4])->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49;
  a00=5.0000000000000000e-01;
  a01=arg[2]? arg[2][0] : 0;
  a02=(2.*a01);
  a03=arg[2]? arg[2][1] : 0;
  a04=(a02*a03);
  a05=arg[2]? arg[2][3] : 0;
  a06=(2.*a05);
  a07=arg[2]? arg[2][2] : 0;
  a08=(a06*a07);
  a08=(a04+a08);
  a09=arg[0]? arg[0][2] : 0;
  a10=arg[0]? arg[0][3] : 0;
  a11=(a09*a10);
  a11=(2.*a11);
  a12=arg[0]? arg[0][0] : 0;
  a13=(2.*a12);
  a14=arg[0]? arg[0][1] : 0;
  a15=(a13*a14);
  a11=(a11-a15);
  a16=1.0000000000000001e-30;
  a17=arg[1]? arg[1][0] : 0;
  a18=casadi_sq(a17);
  a16=(a16+a18);
  a19=arg[1]? arg[1][1] : 0;
  a20=casadi_sq(a19);
  a16=(a16+a20);
  a21=arg[1]? arg[1][2] : 0;
  a22=casadi_sq(a21);
  a16=(a16+a22);
  a23=sqrt(a16);
  a24=(a00*a23);
  a25=sin(a24);
  a26=casadi_sq(a25);
  a26=(a26/a16);
  a16=(a26*a19);
  a16=(a16*a21);
  a16=(2.*a16);
  a24=cos(a24);
  a25=(a25*a24);
  a25=(a25/a23);
  a23=(a25*a17);
  a23=(2.*a23);
  a16=(a16-a23);
  a27=(a11*a16);
  a28=(a13*a10);
  a29=(2.*a09);
  a30=(a29*a14);
  a30=(a28+a30);
  a17=(a26*a17);
  a31=(2.*a19);
  a32=(a17*a31);
  a21=(2.*a21);
  a33=(a21*a25);
  a34=(a32+a33);
  a35=(a30*a34);
  a27=(a27+a35);
  a35=casadi_sq(a09);
  a12=casadi_sq(a12);
  a36=casadi_sq(a14);
  a37=(a12-a36);
  a38=(a35+a37);
  a39=casadi_sq(a10);
  a38=(a38-a39);
  a22=(a26*a22);
  a24=casadi_sq(a24);
  a40=(a22-a24);
  a18=(a26*a18);
  a20=(a26*a20);
  a41=(a18-a20);
  a40=(a40+a41);
  a42=(a38*a40);
  a27=(a27-a42);
  a42=(a08*a27);
  a42=(a00*a42);
  a43=(a03*a05);
  a43=(2.*a43);
  a44=(a02*a07);
  a43=(a43-a44);
  a17=(a21*a17);
  a25=(a25*a31);
  a31=(a17+a25);
  a45=(a11*a31);
  a46=(a24-a22);
  a46=(a46+a41);
  a41=(a30*a46);
  a45=(a45+a41);
  a32=(a32-a33);
  a33=(a38*a32);
  a45=(a45+a33);
  a33=(a43*a45);
  a33=(a00*a33);
  a42=(a42+a33);
  a33=casadi_sq(a05);
  a41=casadi_sq(a07);
  a47=(a33-a41);
  a01=casadi_sq(a01);
  a48=casadi_sq(a03);
  a49=(a01-a48);
  a47=(a47+a49);
  a26=(a26*a21);
  a26=(a26*a19);
  a23=(a23+a26);
  a38=(a23*a38);
  a17=(a17-a25);
  a30=(a17*a30);
  a38=(a38+a30);
  a18=(a18-a24);
  a18=(a18+a20);
  a18=(a18-a22);
  a11=(a18*a11);
  a38=(a38-a11);
  a11=(a47*a38);
  a11=(a00*a11);
  a42=(a42+a11);
  a11=(a07*a05);
  a11=(2.*a11);
  a11=(a11-a04);
  a29=(a29*a10);
  a15=(a15+a29);
  a29=(a23*a15);
  a10=(a14*a10);
  a10=(2.*a10);
  a13=(a13*a09);
  a04=(a10-a13);
  a22=(a04*a17);
  a29=(a29+a22);
  a22=(a39-a35);
  a22=(a22+a37);
  a37=(a22*a18);
  a29=(a29-a37);
  a37=(a11*a29);
  a37=(a00*a37);
  a42=(a42-a37);
  a02=(a02*a05);
  a07=(a03*a07);
  a07=(2.*a07);
  a05=(a02+a07);
  a37=(a04*a46);
  a20=(a22*a31);
  a37=(a37+a20);
  a20=(a15*a32);
  a37=(a37+a20);
  a20=(a05*a37);
  a20=(a00*a20);
  a42=(a42-a20);
  a49=(a41+a49);
  a49=(a49-a33);
  a04=(a04*a34);
  a22=(a22*a16);
  a04=(a04+a22);
  a15=(a40*a15);
  a04=(a04-a15);
  a15=(a49*a04);
  a15=(a00*a15);
  a42=(a42-a15);
  if (res[0]!=0) res[0][0]=a42;
  a06=(a06*a03);
  a44=(a44+a06);
  a29=(a29*a44);
  a29=(a00*a29);
  a01=(a01-a41);
  a01=(a01+a48);
  a01=(a01-a33);
  a37=(a37*a01);
  a37=(a00*a37);
  a29=(a29+a37);
  a07=(a07-a02);
  a04=(a04*a07);
  a04=(a00*a04);
  a29=(a29+a04);
  a13=(a13+a10);
  a16=(a16*a13);
  a12=(a12-a35);
  a12=(a12+a36);
  a12=(a12-a39);
  a34=(a34*a12);
  a16=(a16+a34);
  a14=(a14*a09);
  a14=(2.*a14);
  a14=(a14-a28);
  a40=(a40*a14);
  a16=(a16-a40);
  a08=(a08*a16);
  a08=(a00*a08);
  a29=(a29-a08);
  a31=(a31*a13);
  a32=(a32*a14);
  a31=(a31+a32);
  a46=(a46*a12);
  a31=(a31+a46);
  a43=(a43*a31);
  a43=(a00*a43);
  a29=(a29-a43);
  a23=(a23*a14);
  a17=(a17*a12);
  a23=(a23+a17);
  a18=(a18*a13);
  a23=(a23-a18);
  a47=(a47*a23);
  a47=(a00*a47);
  a29=(a29-a47);
  if (res[0]!=0) res[0][1]=a29;
  a11=(a11*a23);
  a11=(a00*a11);
  a05=(a05*a31);
  a05=(a00*a05);
  a11=(a11+a05);
  a49=(a49*a16);
  a49=(a00*a49);
  a11=(a11+a49);
  a27=(a27*a07);
  a27=(a00*a27);
  a11=(a11-a27);
  a45=(a45*a01);
  a45=(a00*a45);
  a11=(a11-a45);
  a38=(a38*a44);
  a00=(a00*a38);
  a11=(a11-a00);
  if (res[0]!=0) res[0][2]=a11;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_exact_z_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_exact_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vd_dcm_exact_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_exact_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_b2n_wxyz";
    case 1: return "mu";
    case 2: return "q_r2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_exact_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_exact_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_exact_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


