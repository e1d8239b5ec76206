/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) val_dcm_z_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void val_dcm_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int val_dcm_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int val_dcm_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* val_dcm_z_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],q_m2n_wxyz[4],lag)->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60;
  a00=5.0000000000000000e-01;
  a01=arg[5]? arg[5][0] : 0;
  a02=(2.*a01);
  a03=arg[5]? arg[5][3] : 0;
  a04=(a02*a03);
  a05=arg[5]? arg[5][2] : 0;
  a06=(2.*a05);
  a07=arg[5]? arg[5][1] : 0;
  a06=(a06*a07);
  a08=(a04+a06);
  a09=arg[3]? arg[3][0] : 0;
  a10=arg[2]? arg[2][3] : 0;
  a11=(a09*a10);
  a12=arg[3]? arg[3][1] : 0;
  a13=arg[2]? arg[2][2] : 0;
  a14=(a12*a13);
  a11=(a11+a14);
  a14=arg[3]? arg[3][2] : 0;
  a15=arg[2]? arg[2][1] : 0;
  a16=(a14*a15);
  a11=(a11-a16);
  a16=arg[3]? arg[3][3] : 0;
  a17=arg[2]? arg[2][0] : 0;
  a18=(a16*a17);
  a11=(a11-a18);
  a18=(a09*a15);
  a19=(a14*a10);
  a18=(a18+a19);
  a19=(a12*a17);
  a18=(a18-a19);
  a19=(a16*a13);
  a18=(a18-a19);
  a19=(a11*a18);
  a19=(2.*a19);
  a20=(a09*a17);
  a21=(a12*a15);
  a20=(a20+a21);
  a21=(a14*a13);
  a20=(a20+a21);
  a21=(a16*a10);
  a20=(a20+a21);
  a21=(2.*a20);
  a09=(a09*a13);
  a16=(a16*a15);
  a09=(a09+a16);
  a12=(a12*a10);
  a09=(a09-a12);
  a14=(a14*a17);
  a09=(a09-a14);
  a14=(a21*a09);
  a12=(a19-a14);
  a16=(a08*a12);
  a16=(a00*a16);
  a22=(a05*a03);
  a22=(2.*a22);
  a23=(a02*a07);
  a24=(a22-a23);
  a25=casadi_sq(a11);
  a26=casadi_sq(a09);
  a27=(a25-a26);
  a20=casadi_sq(a20);
  a28=casadi_sq(a18);
  a29=(a20-a28);
  a27=(a27+a29);
  a30=(a24*a27);
  a30=(a00*a30);
  a16=(a16+a30);
  a30=casadi_sq(a05);
  a01=casadi_sq(a01);
  a31=casadi_sq(a07);
  a32=(a01-a31);
  a33=(a30+a32);
  a34=casadi_sq(a03);
  a33=(a33-a34);
  a35=(a21*a18);
  a36=(2.*a11);
  a36=(a09*a36);
  a37=(a35+a36);
  a38=(a33*a37);
  a38=(a00*a38);
  a16=(a16+a38);
  a38=arg[6]? arg[6][0] : 0;
  a39=arg[4]? arg[4][0] : 0;
  a40=casadi_sq(a15);
  a41=casadi_sq(a13);
  a42=(a40-a41);
  a43=casadi_sq(a17);
  a44=casadi_sq(a10);
  a45=(a43-a44);
  a46=(a42+a45);
  a46=(a39*a46);
  a47=arg[4]? arg[4][1] : 0;
  a48=(a15*a13);
  a48=(2.*a48);
  a17=(2.*a17);
  a49=(a17*a10);
  a50=(a48-a49);
  a50=(a47*a50);
  a46=(a46+a50);
  a50=arg[4]? arg[4][2] : 0;
  a51=(a17*a13);
  a52=(2.*a15);
  a52=(a52*a10);
  a53=(a51+a52);
  a53=(a50*a53);
  a46=(a46+a53);
  a53=arg[1]? arg[1][1] : 0;
  a54=arg[0]? arg[0][2] : 0;
  a55=6378137.;
  a56=1.;
  a57=6.6943799901413173e-03;
  a58=arg[0]? arg[0][0] : 0;
  a59=sin(a58);
  a60=casadi_sq(a59);
  a57=(a57*a60);
  a56=(a56-a57);
  a57=sqrt(a56);
  a55=(a55/a57);
  a55=(a54+a55);
  a53=(a53/a55);
  a46=(a46-a53);
  a55=7.2921149999999999e-05;
  a58=cos(a58);
  a60=(a55*a58);
  a46=(a46-a60);
  a46=(a38*a46);
  a16=(a16-a46);
  a11=(a11*a21);
  a18=(a18*a09);
  a18=(2.*a18);
  a09=(a11+a18);
  a07=(a07*a03);
  a07=(2.*a07);
  a02=(a02*a05);
  a05=(a07-a02);
  a03=(a09*a05);
  a03=(a00*a03);
  a16=(a16-a03);
  a29=(a26+a29);
  a29=(a29-a25);
  a23=(a23+a22);
  a22=(a29*a23);
  a22=(a00*a22);
  a16=(a16-a22);
  a36=(a36-a35);
  a35=(a34-a30);
  a35=(a35+a32);
  a32=(a36*a35);
  a32=(a00*a32);
  a16=(a16-a32);
  if (res[0]!=0) res[0][0]=a16;
  a20=(a20-a26);
  a20=(a20+a28);
  a20=(a20-a25);
  a05=(a05*a20);
  a05=(a00*a05);
  a18=(a18-a11);
  a23=(a23*a18);
  a23=(a00*a23);
  a05=(a05+a23);
  a14=(a14+a19);
  a35=(a35*a14);
  a35=(a00*a35);
  a05=(a05+a35);
  a49=(a49+a48);
  a49=(a39*a49);
  a45=(a45-a42);
  a45=(a47*a45);
  a49=(a49+a45);
  a13=(a13*a10);
  a13=(2.*a13);
  a17=(a17*a15);
  a15=(a13-a17);
  a15=(a50*a15);
  a49=(a49+a15);
  a15=arg[1]? arg[1][0] : 0;
  a10=6.3354393272928204e+06;
  a56=(a56*a57);
  a10=(a10/a56);
  a54=(a54+a10);
  a15=(a15/a54);
  a49=(a49+a15);
  a49=(a38*a49);
  a05=(a05-a49);
  a01=(a01-a30);
  a01=(a01+a31);
  a01=(a01-a34);
  a12=(a12*a01);
  a12=(a00*a12);
  a05=(a05-a12);
  a02=(a02+a07);
  a27=(a27*a02);
  a27=(a00*a27);
  a05=(a05-a27);
  a06=(a06-a04);
  a37=(a37*a06);
  a37=(a00*a37);
  a05=(a05-a37);
  if (res[0]!=0) res[0][1]=a05;
  a09=(a09*a01);
  a09=(a00*a09);
  a29=(a29*a06);
  a29=(a00*a29);
  a09=(a09+a29);
  a36=(a36*a02);
  a36=(a00*a36);
  a09=(a09+a36);
  a55=(a55*a59);
  a59=(a59/a58);
  a53=(a53*a59);
  a55=(a55+a53);
  a52=(a52-a51);
  a39=(a39*a52);
  a55=(a55+a39);
  a17=(a17+a13);
  a47=(a47*a17);
  a55=(a55+a47);
  a40=(a40+a41);
  a43=(a43-a40);
  a43=(a43+a44);
  a50=(a50*a43);
  a55=(a55+a50);
  a38=(a38*a55);
  a09=(a09-a38);
  a08=(a08*a20);
  a08=(a00*a08);
  a09=(a09-a08);
  a24=(a24*a14);
  a24=(a00*a24);
  a09=(a09-a24);
  a33=(a33*a18);
  a00=(a00*a33);
  a09=(a09-a00);
  if (res[0]!=0) res[0][2]=a09;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_dcm_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int val_dcm_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void val_dcm_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void val_dcm_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void val_dcm_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int val_dcm_z_casadi_n_in(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_int val_dcm_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real val_dcm_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_dcm_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "q_m2n_wxyz";
    case 6: return "lag";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_dcm_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_dcm_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_dcm_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int val_dcm_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_dcm_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


