/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) ah_azimuth_z_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void ah_azimuth_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int ah_azimuth_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int ah_azimuth_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {1, 1, 1};

/* ah_azimuth_z_casadi:(q_b2n_wxyz[4],q_ref_wxyz[4])->(out_z) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  a00=5.0000000000000000e-01;
  a01=arg[0]? arg[0][1] : 0;
  a02=casadi_sq(a01);
  a03=arg[0]? arg[0][0] : 0;
  a04=casadi_sq(a03);
  a05=arg[0]? arg[0][3] : 0;
  a06=casadi_sq(a05);
  a04=(a04-a06);
  a06=(a02+a04);
  a07=arg[0]? arg[0][2] : 0;
  a08=casadi_sq(a07);
  a06=(a06-a08);
  a09=arg[1]? arg[1][0] : 0;
  a10=(2.*a09);
  a11=arg[1]? arg[1][3] : 0;
  a12=(a10*a11);
  a13=arg[1]? arg[1][1] : 0;
  a14=(2.*a13);
  a15=arg[1]? arg[1][2] : 0;
  a16=(a14*a15);
  a17=(a12+a16);
  a06=(a06*a17);
  a06=(a00*a06);
  a17=(2.*a01);
  a18=(a17*a07);
  a03=(2.*a03);
  a19=(a03*a05);
  a20=(a18-a19);
  a21=casadi_sq(a15);
  a09=casadi_sq(a09);
  a22=casadi_sq(a11);
  a09=(a09-a22);
  a22=(a21+a09);
  a23=casadi_sq(a13);
  a22=(a22-a23);
  a20=(a20*a22);
  a20=(a00*a20);
  a06=(a06+a20);
  a17=(a17*a05);
  a20=(a03*a07);
  a17=(a17+a20);
  a20=(2.*a15);
  a20=(a20*a11);
  a13=(a10*a13);
  a20=(a20-a13);
  a17=(a17*a20);
  a17=(a00*a17);
  a06=(a06+a17);
  a19=(a19+a18);
  a23=(a23+a09);
  a23=(a23-a21);
  a19=(a19*a23);
  a19=(a00*a19);
  a06=(a06-a19);
  a08=(a08+a04);
  a08=(a08-a02);
  a16=(a16-a12);
  a08=(a08*a16);
  a08=(a00*a08);
  a06=(a06-a08);
  a07=(2.*a07);
  a07=(a07*a05);
  a03=(a03*a01);
  a07=(a07-a03);
  a10=(a10*a15);
  a14=(a14*a11);
  a10=(a10+a14);
  a07=(a07*a10);
  a00=(a00*a07);
  a06=(a06-a00);
  if (res[0]!=0) res[0][0]=a06;
  return 0;
}

CASADI_SYMBOL_EXPORT int ah_azimuth_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ah_azimuth_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ah_azimuth_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ah_azimuth_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void ah_azimuth_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ah_azimuth_z_casadi_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int ah_azimuth_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real ah_azimuth_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ah_azimuth_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_b2n_wxyz";
    case 1: return "q_ref_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ah_azimuth_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ah_azimuth_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ah_azimuth_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ah_azimuth_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ah_azimuth_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


