/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) sd_earth_casadi__ ## ID
#endif

#include <math.h>
#include "../src/sd_math.h"
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
CASADI_SYMBOL_EXPORT void sd_earth_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int sd_earth_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int sd_earth_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {2, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* sd_earth_casadi:(lon_lat_height[3],v_n[3])->(out_omega_ie_n[2],out_omega_en_n[3],out_gravity_n) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
  a0=7.2921149999999999e-05;
  a1=arg[0]? arg[0][1] : 0;
  a2=cos(a1);
  a3=(a0*a2);
  if (res[0]!=0) res[0][0]=a3;
  a1=sin(a1);
  a0=(a0*a1);
  if (res[0]!=0) res[0][1]=a0;
  a0=arg[1]? arg[1][1] : 0;
  a3=arg[0]? arg[0][2] : 0;
  a4=6.3354393272928204e+06;
  a5=1.;
  a6=6.6943799901413173e-03;
  a7=(a1*a1);
  a6=(a6*a7);
  a6=(a5-a6);
  a8=sqrt(a6);
  a6=(a6*a8);
  a4=(a4/a6);
  a4=(a3+a4);
  a0=(a0/a4);
  a0=(-a0);
  if (res[1]!=0) res[1][0]=a0;
  a0=arg[1]? arg[1][0] : 0;
  a4=6378137.;
  a8=(a5/a8);
  a4=(a4*a8);
  a4=(a3+a4);
  a0=(a0/a4);
  if (res[1]!=0) res[1][1]=a0;
  a1=(a1/a2);
  a0=(a0*a1);
  if (res[1]!=0) res[1][2]=a0;
  a0=7.3745167729419953e-14;
  a1=(a3*a3);
  a0=(a0*a1);
  a5=(a5+a0);
  a0=1.5678559428873979e-07;
  a1=2.0136051943431768e+00;
  a2=1.3411242658989924e-02;
  a2=(a2*a7);
  a1=(a1-a2);
  a3=(a3*a1);
  a0=(a0*a3);
  a5=(a5-a0);
  a0=9.7803253359000006e+00;
  a3=1.8894147482439335e-02;
  a3=(a3*a7);
  a0=(a0+a3);
  a0=(a0*a8);
  a5=(a5*a0);
  a5=(-a5);
  if (res[2]!=0) res[2][0]=a5;
  return 0;
}

CASADI_SYMBOL_EXPORT int sd_earth_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int sd_earth_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void sd_earth_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void sd_earth_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void sd_earth_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int sd_earth_casadi_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int sd_earth_casadi_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real sd_earth_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sd_earth_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sd_earth_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_omega_ie_n";
    case 1: return "out_omega_en_n";
    case 2: return "out_gravity_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sd_earth_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sd_earth_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s0;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int sd_earth_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int sd_earth_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


