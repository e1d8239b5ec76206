/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_dcm_z_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vd_dcm_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};

/* vd_dcm_z_casadi:(q_b2n_wxyz[4],mu[3],q_r2n_wxyz[4])->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48;
  a00=arg[0]? arg[0][2] : 0;
  a01=arg[0]? arg[0][3] : 0;
  a02=(a00*a01);
  a02=(2.*a02);
  a03=arg[0]? arg[0][0] : 0;
  a04=(2.*a03);
  a05=arg[0]? arg[0][1] : 0;
  a06=(a04*a05);
  a02=(a02-a06);
  a07=5.0000000000000000e-01;
  a08=1.0000000000000001e-30;
  a09=arg[1]? arg[1][0] : 0;
  a10=casadi_sq(a09);
  a08=(a08+a10);
  a11=arg[1]? arg[1][1] : 0;
  a12=casadi_sq(a11);
  a08=(a08+a12);
  a13=arg[1]? arg[1][2] : 0;
  a14=casadi_sq(a13);
  a08=(a08+a14);
  a15=sqrt(a08);
  a16=(a07*a15);
  a17=sin(a16);
  a18=casadi_sq(a17);
  a18=(a18/a08);
  a08=(a18*a11);
  a08=(a08*a13);
  a08=(2.*a08);
  a09=(2.*a09);
  a16=cos(a16);
  a17=(a17*a16);
  a17=(a17/a15);
  a15=(a09*a17);
  a08=(a08-a15);
  a19=arg[2]? arg[2][0] : 0;
  a20=(2.*a19);
  a21=arg[2]? arg[2][1] : 0;
  a22=(a20*a21);
  a23=arg[2]? arg[2][3] : 0;
  a24=(2.*a23);
  a25=arg[2]? arg[2][2] : 0;
  a26=(a24*a25);
  a26=(a22+a26);
  a27=(a08*a26);
  a27=(a07*a27);
  a28=(a21*a23);
  a28=(2.*a28);
  a29=(a20*a25);
  a28=(a28-a29);
  a30=(a18*a13);
  a31=(a09*a30);
  a32=(2.*a11);
  a33=(a17*a32);
  a34=(a31+a33);
  a35=(a28*a34);
  a35=(a07*a35);
  a27=(a27+a35);
  a35=casadi_sq(a23);
  a36=casadi_sq(a25);
  a37=(a35-a36);
  a19=casadi_sq(a19);
  a38=casadi_sq(a21);
  a39=(a19-a38);
  a37=(a37+a39);
  a12=(a18*a12);
  a16=casadi_sq(a16);
  a40=(a12-a16);
  a10=(a18*a10);
  a14=(a18*a14);
  a41=(a10-a14);
  a40=(a40+a41);
  a42=(a37*a40);
  a42=(a07*a42);
  a27=(a27-a42);
  a42=(a02*a27);
  a43=(a04*a01);
  a44=(2.*a00);
  a45=(a44*a05);
  a45=(a43+a45);
  a41=(a16+a41);
  a41=(a41-a12);
  a46=(a28*a41);
  a46=(a07*a46);
  a31=(a31-a33);
  a33=(a37*a31);
  a33=(a07*a33);
  a46=(a46+a33);
  a09=(a09*a18);
  a09=(a09*a11);
  a17=(a17*a13);
  a17=(2.*a17);
  a13=(a09+a17);
  a11=(a13*a26);
  a11=(a07*a11);
  a46=(a46+a11);
  a11=(a45*a46);
  a42=(a42+a11);
  a11=casadi_sq(a00);
  a03=casadi_sq(a03);
  a18=casadi_sq(a05);
  a33=(a03-a18);
  a47=(a11+a33);
  a48=casadi_sq(a01);
  a47=(a47-a48);
  a09=(a09-a17);
  a28=(a28*a09);
  a28=(a07*a28);
  a30=(a30*a32);
  a15=(a15+a30);
  a37=(a37*a15);
  a37=(a07*a37);
  a28=(a28+a37);
  a10=(a10-a16);
  a10=(a10+a14);
  a10=(a10-a12);
  a26=(a10*a26);
  a26=(a07*a26);
  a28=(a28-a26);
  a26=(a47*a28);
  a42=(a42+a26);
  a26=(a25*a23);
  a26=(2.*a26);
  a26=(a26-a22);
  a22=(a26*a15);
  a20=(a20*a23);
  a25=(a21*a25);
  a25=(2.*a25);
  a23=(a20+a25);
  a12=(a23*a09);
  a22=(a22+a12);
  a39=(a36+a39);
  a39=(a39-a35);
  a12=(a39*a10);
  a22=(a22-a12);
  a06=(a07*a06);
  a44=(a44*a01);
  a44=(a07*a44);
  a06=(a06+a44);
  a44=(a22*a06);
  a42=(a42-a44);
  a44=(a26*a31);
  a12=(a23*a41);
  a44=(a44+a12);
  a12=(a39*a13);
  a44=(a44+a12);
  a01=(a05*a01);
  a04=(a04*a00);
  a12=(a07*a04);
  a12=(a01-a12);
  a14=(a44*a12);
  a42=(a42-a14);
  a39=(a08*a39);
  a23=(a34*a23);
  a39=(a39+a23);
  a26=(a40*a26);
  a39=(a39-a26);
  a26=(a07*a48);
  a23=(a07*a11);
  a26=(a26-a23);
  a33=(a07*a33);
  a26=(a26+a33);
  a33=(a39*a26);
  a42=(a42-a33);
  if (res[0]!=0) res[0][0]=a42;
  a24=(a24*a21);
  a29=(a29+a24);
  a15=(a15*a29);
  a19=(a19-a36);
  a19=(a19+a38);
  a19=(a19-a35);
  a09=(a09*a19);
  a15=(a15+a09);
  a25=(a25-a20);
  a10=(a10*a25);
  a15=(a15-a10);
  a06=(a06*a15);
  a31=(a31*a29);
  a13=(a13*a25);
  a31=(a31+a13);
  a41=(a41*a19);
  a31=(a31+a41);
  a12=(a12*a31);
  a06=(a06+a12);
  a08=(a08*a25);
  a34=(a34*a19);
  a08=(a08+a34);
  a40=(a40*a29);
  a08=(a08-a40);
  a26=(a26*a08);
  a06=(a06+a26);
  a01=(2.*a01);
  a04=(a04+a01);
  a27=(a27*a04);
  a06=(a06-a27);
  a03=(a03-a11);
  a03=(a03+a18);
  a03=(a03-a48);
  a46=(a46*a03);
  a06=(a06-a46);
  a05=(a05*a00);
  a05=(2.*a05);
  a05=(a05-a43);
  a28=(a28*a05);
  a06=(a06-a28);
  if (res[0]!=0) res[0][1]=a06;
  a22=(a22*a05);
  a22=(a07*a22);
  a44=(a44*a03);
  a44=(a07*a44);
  a22=(a22+a44);
  a39=(a39*a04);
  a39=(a07*a39);
  a22=(a22+a39);
  a02=(a02*a08);
  a02=(a07*a02);
  a22=(a22-a02);
  a45=(a45*a31);
  a45=(a07*a45);
  a22=(a22-a45);
  a47=(a47*a15);
  a07=(a07*a47);
  a22=(a22-a07);
  if (res[0]!=0) res[0][2]=a22;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vd_dcm_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_z_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vd_dcm_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_b2n_wxyz";
    case 1: return "mu";
    case 2: return "q_r2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


