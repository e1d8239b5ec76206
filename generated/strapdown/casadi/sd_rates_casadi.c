/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) sd_rates_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void sd_rates_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int sd_rates_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int sd_rates_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};

/* sd_rates_casadi:(lon_lat_height[3],v_n[3],q_b2n_wxyz[4],f_b[3],omega_ib_b[3])->(out_position_rate[3],out_v_n_rate[3],out_q_b2n_rate[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[0]? arg[0][2] : 0;
  a02=6378137.;
  a03=1.;
  a04=6.6943799901413173e-03;
  a05=arg[0]? arg[0][1] : 0;
  a06=sin(a05);
  a07=(a06*a06);
  a04=(a04*a07);
  a04=(a03-a04);
  a08=sqrt(a04);
  a09=(a03/a08);
  a02=(a02*a09);
  a02=(a01+a02);
  a02=(a00/a02);
  a05=cos(a05);
  a10=(a03/a05);
  a11=(a02*a10);
  if (res[0]!=0) res[0][0]=a11;
  a11=arg[1]? arg[1][1] : 0;
  a12=6.3354393272928204e+06;
  a04=(a04*a08);
  a12=(a12/a04);
  a12=(a01+a12);
  a12=(a11/a12);
  if (res[0]!=0) res[0][1]=a12;
  a04=arg[1]? arg[1][2] : 0;
  if (res[0]!=0) res[0][2]=a04;
  a08=1.4584230000000000e-04;
  a13=(a08*a06);
  a10=(a06*a10);
  a10=(a02*a10);
  a13=(a13+a10);
  a14=(a11*a13);
  a15=arg[3]? arg[3][0] : 0;
  a16=arg[2]? arg[2][1] : 0;
  a17=(a16*a16);
  a18=arg[2]? arg[2][2] : 0;
  a19=(a18*a18);
  a20=(a17-a19);
  a21=arg[2]? arg[2][0] : 0;
  a22=(a21*a21);
  a23=arg[2]? arg[2][3] : 0;
  a24=(a23*a23);
  a25=(a22-a24);
  a20=(a20+a25);
  a20=(a15*a20);
  a26=arg[3]? arg[3][1] : 0;
  a27=2.;
  a28=(a27*a16);
  a29=(a28*a18);
  a30=(a27*a21);
  a31=(a30*a23);
  a32=(a29-a31);
  a32=(a26*a32);
  a20=(a20+a32);
  a32=arg[3]? arg[3][2] : 0;
  a33=(a30*a18);
  a28=(a28*a23);
  a34=(a33+a28);
  a34=(a32*a34);
  a20=(a20+a34);
  a14=(a14+a20);
  a08=(a08*a05);
  a08=(a08+a02);
  a20=(a04*a08);
  a14=(a14-a20);
  if (res[1]!=0) res[1][0]=a14;
  a31=(a31+a29);
  a31=(a15*a31);
  a25=(a19+a25);
  a25=(a25-a17);
  a25=(a26*a25);
  a31=(a31+a25);
  a27=(a27*a18);
  a27=(a27*a23);
  a30=(a30*a16);
  a25=(a27-a30);
  a25=(a32*a25);
  a31=(a31+a25);
  a04=(a04*a12);
  a31=(a31-a04);
  a13=(a00*a13);
  a31=(a31-a13);
  if (res[1]!=0) res[1][1]=a31;
  a00=(a00*a08);
  a28=(a28-a33);
  a15=(a15*a28);
  a30=(a30+a27);
  a26=(a26*a30);
  a15=(a15+a26);
  a22=(a22-a19);
  a22=(a22+a24);
  a22=(a22-a17);
  a32=(a32*a22);
  a15=(a15+a32);
  a00=(a00+a15);
  a15=7.3745167729419953e-14;
  a32=(a01*a01);
  a15=(a15*a32);
  a03=(a03+a15);
  a15=1.5678559428873979e-07;
  a32=2.0136051943431768e+00;
  a22=1.3411242658989924e-02;
  a22=(a22*a07);
  a32=(a32-a22);
  a01=(a01*a32);
  a15=(a15*a01);
  a03=(a03-a15);
  a15=9.7803253359000006e+00;
  a01=1.8894147482439335e-02;
  a01=(a01*a07);
  a15=(a15+a01);
  a15=(a15*a09);
  a03=(a03*a15);
  a00=(a00-a03);
  a11=(a11*a12);
  a00=(a00+a11);
  if (res[1]!=0) res[1][2]=a00;
  a00=5.0000000000000000e-01;
  a11=(a00*a18);
  a03=7.2921149999999999e-05;
  a05=(a03*a05);
  a02=(a02+a05);
  a05=(a11*a02);
  a15=(a00*a16);
  a09=(a15*a12);
  a05=(a05-a09);
  a23=(a00*a23);
  a03=(a03*a06);
  a10=(a10+a03);
  a03=(a23*a10);
  a05=(a05+a03);
  a03=arg[4]? arg[4][0] : 0;
  a06=(a15*a03);
  a05=(a05-a06);
  a06=arg[4]? arg[4][1] : 0;
  a09=(a11*a06);
  a05=(a05-a09);
  a09=arg[4]? arg[4][2] : 0;
  a01=(a23*a09);
  a05=(a05-a01);
  if (res[2]!=0) res[2][0]=a05;
  a05=(a03*a21);
  a05=(a00*a05);
  a01=(a09*a18);
  a01=(a00*a01);
  a05=(a05+a01);
  a18=(a18*a10);
  a18=(a00*a18);
  a05=(a05+a18);
  a18=(a23*a06);
  a05=(a05-a18);
  a18=(a23*a02);
  a05=(a05-a18);
  a18=(a00*a21);
  a01=(a18*a12);
  a05=(a05+a01);
  if (res[2]!=0) res[2][1]=a05;
  a05=(a23*a03);
  a23=(a23*a12);
  a05=(a05-a23);
  a23=(a18*a06);
  a05=(a05+a23);
  a23=(a15*a09);
  a05=(a05-a23);
  a15=(a15*a10);
  a05=(a05-a15);
  a15=(a18*a02);
  a05=(a05-a15);
  if (res[2]!=0) res[2][2]=a05;
  a06=(a06*a16);
  a06=(a00*a06);
  a09=(a09*a21);
  a09=(a00*a09);
  a06=(a06+a09);
  a16=(a16*a02);
  a00=(a00*a16);
  a06=(a06+a00);
  a03=(a11*a03);
  a06=(a06-a03);
  a11=(a11*a12);
  a06=(a06+a11);
  a18=(a18*a10);
  a06=(a06-a18);
  if (res[2]!=0) res[2][3]=a06;
  return 0;
}

CASADI_SYMBOL_EXPORT int sd_rates_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int sd_rates_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void sd_rates_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void sd_rates_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void sd_rates_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int sd_rates_casadi_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int sd_rates_casadi_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real sd_rates_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sd_rates_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "f_b";
    case 4: return "omega_ib_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sd_rates_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_position_rate";
    case 1: return "out_v_n_rate";
    case 2: return "out_q_b2n_rate";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sd_rates_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sd_rates_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int sd_rates_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int sd_rates_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


