/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) ahr_azimuth_z_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void ahr_azimuth_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int ahr_azimuth_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int ahr_azimuth_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {1, 1, 1};

/* ahr_azimuth_z_casadi:(q_b2n_wxyz[4],q_ref_wxyz[4],reference_error)->(out_z) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  a00=arg[2]? arg[2][0] : 0;
  a01=5.0000000000000000e-01;
  a02=arg[0]? arg[0][1] : 0;
  a03=casadi_sq(a02);
  a04=arg[0]? arg[0][0] : 0;
  a05=casadi_sq(a04);
  a06=arg[0]? arg[0][3] : 0;
  a07=casadi_sq(a06);
  a05=(a05-a07);
  a07=(a03+a05);
  a08=arg[0]? arg[0][2] : 0;
  a09=casadi_sq(a08);
  a07=(a07-a09);
  a10=arg[1]? arg[1][0] : 0;
  a11=(2.*a10);
  a12=arg[1]? arg[1][3] : 0;
  a13=(a11*a12);
  a14=arg[1]? arg[1][1] : 0;
  a15=(2.*a14);
  a16=arg[1]? arg[1][2] : 0;
  a17=(a15*a16);
  a18=(a13+a17);
  a07=(a07*a18);
  a07=(a01*a07);
  a00=(a00+a07);
  a07=(2.*a02);
  a18=(a07*a08);
  a04=(2.*a04);
  a19=(a04*a06);
  a20=(a18-a19);
  a21=casadi_sq(a16);
  a10=casadi_sq(a10);
  a22=casadi_sq(a12);
  a10=(a10-a22);
  a22=(a21+a10);
  a23=casadi_sq(a14);
  a22=(a22-a23);
  a20=(a20*a22);
  a20=(a01*a20);
  a00=(a00+a20);
  a07=(a07*a06);
  a20=(a04*a08);
  a07=(a07+a20);
  a20=(2.*a16);
  a20=(a20*a12);
  a14=(a11*a14);
  a20=(a20-a14);
  a07=(a07*a20);
  a07=(a01*a07);
  a00=(a00+a07);
  a19=(a19+a18);
  a23=(a23+a10);
  a23=(a23-a21);
  a19=(a19*a23);
  a19=(a01*a19);
  a00=(a00-a19);
  a09=(a09+a05);
  a09=(a09-a03);
  a17=(a17-a13);
  a09=(a09*a17);
  a09=(a01*a09);
  a00=(a00-a09);
  a08=(2.*a08);
  a08=(a08*a06);
  a04=(a04*a02);
  a08=(a08-a04);
  a11=(a11*a16);
  a15=(a15*a12);
  a11=(a11+a15);
  a08=(a08*a11);
  a01=(a01*a08);
  a00=(a00-a01);
  if (res[0]!=0) res[0][0]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int ahr_azimuth_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ahr_azimuth_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ahr_azimuth_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ahr_azimuth_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void ahr_azimuth_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ahr_azimuth_z_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int ahr_azimuth_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real ahr_azimuth_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ahr_azimuth_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_b2n_wxyz";
    case 1: return "q_ref_wxyz";
    case 2: return "reference_error";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ahr_azimuth_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ahr_azimuth_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ahr_azimuth_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ahr_azimuth_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ahr_azimuth_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


