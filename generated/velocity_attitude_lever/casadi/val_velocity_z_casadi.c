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
  casadi_real a24, a25, a26;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[4]? arg[4][0] : 0;
  a02=arg[2]? arg[2][0] : 0;
  a03=(2.*a02);
  a04=arg[2]? arg[2][3] : 0;
  a05=(a03*a04);
  a06=arg[2]? arg[2][1] : 0;
  a07=(2.*a06);
  a08=arg[2]? arg[2][2] : 0;
  a07=(a07*a08);
  a09=(a05+a07);
  a10=7.2921149999999999e-05;
  a11=arg[0]? arg[0][0] : 0;
  a12=sin(a11);
  a13=(a10*a12);
  a14=arg[1]? arg[1][1] : 0;
  a15=arg[0]? arg[0][2] : 0;
  a16=6378137.;
  a17=1.;
  a18=6.6943799901413173e-03;
  a19=casadi_sq(a12);
  a18=(a18*a19);
  a17=(a17-a18);
  a18=sqrt(a17);
  a16=(a16/a18);
  a16=(a15+a16);
  a16=(a14/a16);
  a11=cos(a11);
  a12=(a12/a11);
  a12=(a16*a12);
  a13=(a13+a12);
  a12=(a09*a13);
  a19=(a06*a04);
  a19=(2.*a19);
  a20=(a03*a08);
  a21=(a19-a20);
  a22=6.3354393272928204e+06;
  a17=(a17*a18);
  a22=(a22/a17);
  a15=(a15+a22);
  a15=(a00/a15);
  a22=(a21*a15);
  a12=(a12-a22);
  a12=(a01*a12);
  a00=(a00+a12);
  a12=arg[4]? arg[4][1] : 0;
  a02=casadi_sq(a02);
  a22=casadi_sq(a06);
  a17=(a02-a22);
  a18=casadi_sq(a04);
  a23=(a17-a18);
  a24=casadi_sq(a08);
  a23=(a23+a24);
  a25=(a13*a23);
  a03=(a03*a06);
  a08=(a08*a04);
  a08=(2.*a08);
  a04=(a03+a08);
  a06=(a15*a04);
  a25=(a25-a06);
  a25=(a12*a25);
  a00=(a00+a25);
  a25=arg[4]? arg[4][2] : 0;
  a08=(a08-a03);
  a03=(a13*a08);
  a17=(a18+a17);
  a17=(a17-a24);
  a06=(a15*a17);
  a03=(a03-a06);
  a03=(a25*a03);
  a00=(a00+a03);
  a03=arg[5]? arg[5][0] : 0;
  a00=(a00-a03);
  a03=arg[6]? arg[6][0] : 0;
  a06=arg[7]? arg[7][0] : 0;
  a03=(a03*a06);
  a00=(a00-a03);
  a07=(a07-a05);
  a05=arg[3]? arg[3][2] : 0;
  a03=(a07*a05);
  a20=(a20+a19);
  a19=arg[3]? arg[3][1] : 0;
  a26=(a20*a19);
  a03=(a03-a26);
  a03=(a01*a03);
  a00=(a00-a03);
  a03=arg[3]? arg[3][0] : 0;
  a26=(a20*a03);
  a02=(a02-a18);
  a02=(a02+a22);
  a02=(a02-a24);
  a24=(a02*a05);
  a26=(a26-a24);
  a26=(a12*a26);
  a00=(a00-a26);
  a26=(a02*a19);
  a24=(a07*a03);
  a26=(a26-a24);
  a26=(a25*a26);
  a00=(a00-a26);
  if (res[0]!=0) res[0][0]=a00;
  a00=(a02*a13);
  a10=(a10*a11);
  a16=(a16+a10);
  a10=(a21*a16);
  a00=(a00+a10);
  a00=(a01*a00);
  a14=(a14-a00);
  a00=(a04*a16);
  a10=(a13*a07);
  a00=(a00+a10);
  a00=(a12*a00);
  a14=(a14-a00);
  a00=(a17*a16);
  a13=(a13*a20);
  a00=(a00+a13);
  a00=(a25*a00);
  a14=(a14-a00);
  a00=arg[5]? arg[5][1] : 0;
  a14=(a14-a00);
  a00=arg[6]? arg[6][1] : 0;
  a00=(a00*a06);
  a14=(a14-a00);
  a00=(a23*a05);
  a13=(a08*a19);
  a00=(a00-a13);
  a00=(a01*a00);
  a14=(a14-a00);
  a00=(a08*a03);
  a13=(a09*a05);
  a00=(a00-a13);
  a00=(a12*a00);
  a14=(a14-a00);
  a00=(a09*a19);
  a13=(a23*a03);
  a00=(a00-a13);
  a00=(a25*a00);
  a14=(a14-a00);
  if (res[0]!=0) res[0][1]=a14;
  a14=arg[1]? arg[1][2] : 0;
  a02=(a02*a15);
  a09=(a09*a16);
  a02=(a02+a09);
  a02=(a01*a02);
  a14=(a14+a02);
  a07=(a15*a07);
  a23=(a23*a16);
  a07=(a07+a23);
  a07=(a12*a07);
  a14=(a14+a07);
  a15=(a15*a20);
  a08=(a08*a16);
  a15=(a15+a08);
  a15=(a25*a15);
  a14=(a14+a15);
  a15=arg[5]? arg[5][2] : 0;
  a14=(a14-a15);
  a15=arg[6]? arg[6][2] : 0;
  a15=(a15*a06);
  a14=(a14-a15);
  a15=(a04*a05);
  a06=(a17*a19);
  a15=(a15-a06);
  a01=(a01*a15);
  a14=(a14-a01);
  a17=(a17*a03);
  a05=(a21*a05);
  a17=(a17-a05);
  a12=(a12*a17);
  a14=(a14-a12);
  a21=(a21*a19);
  a04=(a04*a03);
  a21=(a21-a04);
  a25=(a25*a21);
  a14=(a14-a25);
  if (res[0]!=0) res[0][2]=a14;
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


