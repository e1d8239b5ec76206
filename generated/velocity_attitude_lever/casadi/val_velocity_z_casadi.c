/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) val_velocity_z_casadi__ ## ID
#endif

#include <math.h>
#include "../src/val_math.h"
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
CASADI_SYMBOL_EXPORT void val_velocity_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int val_velocity_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int val_velocity_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* val_velocity_z_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],omega_ib_b[3],lever_b[3],v_m_n[3],a_n[3],lag)->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[4]? arg[4][0] : 0;
  a02=arg[2]? arg[2][1] : 0;
  a03=(2.*a02);
  a04=arg[2]? arg[2][3] : 0;
  a05=(a03*a04);
  a06=arg[2]? arg[2][0] : 0;
  a07=(2.*a06);
  a08=arg[2]? arg[2][2] : 0;
  a09=(a07*a08);
  a10=(a05-a09);
  a11=(a01*a10);
  a12=arg[4]? arg[4][1] : 0;
  a13=(a07*a02);
  a14=(2.*a08);
  a14=(a14*a04);
  a15=(a13+a14);
  a16=(a12*a15);
  a11=(a11+a16);
  a16=arg[4]? arg[4][2] : 0;
  a17=casadi_sq(a04);
  a02=casadi_sq(a02);
  a18=(a17-a02);
  a06=casadi_sq(a06);
  a19=casadi_sq(a08);
  a20=(a06-a19);
  a21=(a18+a20);
  a22=(a16*a21);
  a11=(a11+a22);
  a22=arg[0]? arg[0][2] : 0;
  a23=6.3354393272928204e+06;
  a24=1.;
  a25=6.6943799901413173e-03;
  a26=arg[0]? arg[0][0] : 0;
  a27=sin(a26);
  a28=casadi_sq(a27);
  a25=(a25*a28);
  a24=(a24-a25);
  a25=sqrt(a24);
  a24=(a24*a25);
  a23=(a23/a24);
  a23=(a22+a23);
  a23=(a00/a23);
  a24=(a11*a23);
  a00=(a00-a24);
  a24=arg[3]? arg[3][2] : 0;
  a03=(a03*a08);
  a07=(a07*a04);
  a04=(a03-a07);
  a08=(a24*a04);
  a28=arg[3]? arg[3][1] : 0;
  a09=(a09+a05);
  a05=(a28*a09);
  a08=(a08-a05);
  a08=(a01*a08);
  a05=arg[3]? arg[3][0] : 0;
  a29=(a05*a09);
  a20=(a20-a18);
  a18=(a24*a20);
  a29=(a29-a18);
  a29=(a12*a29);
  a08=(a08+a29);
  a29=(a28*a20);
  a18=(a05*a04);
  a29=(a29-a18);
  a29=(a16*a29);
  a08=(a08+a29);
  a00=(a00-a08);
  a07=(a07+a03);
  a03=(a01*a07);
  a02=(a02+a17);
  a06=(a06-a02);
  a06=(a06+a19);
  a19=(a12*a06);
  a03=(a03+a19);
  a14=(a14-a13);
  a13=(a16*a14);
  a03=(a03+a13);
  a13=arg[1]? arg[1][1] : 0;
  a19=6378137.;
  a19=(a19/a25);
  a22=(a22+a19);
  a22=(a13/a22);
  a26=cos(a26);
  a19=(a27/a26);
  a19=(a22*a19);
  a25=7.2921149999999999e-05;
  a27=(a25*a27);
  a19=(a19+a27);
  a27=(a03*a19);
  a00=(a00+a27);
  a27=arg[5]? arg[5][0] : 0;
  a00=(a00-a27);
  a27=arg[6]? arg[6][0] : 0;
  a02=arg[7]? arg[7][0] : 0;
  a27=(a27*a02);
  a00=(a00-a27);
  if (res[0]!=0) res[0][0]=a00;
  a20=(a01*a20);
  a04=(a12*a04);
  a20=(a20+a04);
  a09=(a16*a09);
  a20=(a20+a09);
  a19=(a20*a19);
  a13=(a13-a19);
  a19=(a24*a06);
  a09=(a28*a14);
  a19=(a19-a09);
  a19=(a01*a19);
  a14=(a05*a14);
  a09=(a24*a07);
  a14=(a14-a09);
  a14=(a12*a14);
  a19=(a19+a14);
  a07=(a28*a07);
  a06=(a05*a06);
  a07=(a07-a06);
  a07=(a16*a07);
  a19=(a19+a07);
  a13=(a13-a19);
  a25=(a25*a26);
  a22=(a22+a25);
  a11=(a11*a22);
  a13=(a13-a11);
  a11=arg[5]? arg[5][1] : 0;
  a13=(a13-a11);
  a11=arg[6]? arg[6][1] : 0;
  a11=(a11*a02);
  a13=(a13-a11);
  if (res[0]!=0) res[0][1]=a13;
  a13=arg[1]? arg[1][2] : 0;
  a03=(a03*a22);
  a13=(a13+a03);
  a03=(a24*a15);
  a22=(a28*a21);
  a03=(a03-a22);
  a01=(a01*a03);
  a21=(a05*a21);
  a24=(a24*a10);
  a21=(a21-a24);
  a12=(a12*a21);
  a01=(a01+a12);
  a28=(a28*a10);
  a05=(a05*a15);
  a28=(a28-a05);
  a16=(a16*a28);
  a01=(a01+a16);
  a13=(a13-a01);
  a20=(a20*a23);
  a13=(a13+a20);
  a20=arg[5]? arg[5][2] : 0;
  a13=(a13-a20);
  a20=arg[6]? arg[6][2] : 0;
  a20=(a20*a02);
  a13=(a13-a20);
  if (res[0]!=0) res[0][2]=a13;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_velocity_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int val_velocity_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void val_velocity_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void val_velocity_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void val_velocity_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int val_velocity_z_casadi_n_in(void) { return 8;}

CASADI_SYMBOL_EXPORT casadi_int val_velocity_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real val_velocity_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_velocity_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "omega_ib_b";
    case 4: return "lever_b";
    case 5: return "v_m_n";
    case 6: return "a_n";
    case 7: return "lag";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_velocity_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_velocity_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s0;
    case 7: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_velocity_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int val_velocity_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_velocity_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


