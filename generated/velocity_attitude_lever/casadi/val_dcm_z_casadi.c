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
  a00=5.0000000000000000e-01;
  a01=arg[5]? arg[5][0] : 0;
  a02=(2.*a01);
  a03=arg[5]? arg[5][3] : 0;
  a04=(a02*a03);
  a05=arg[5]? arg[5][2] : 0;
  a06=(2.*a05);
  a07=arg[5]? arg[5][1] : 0;
  a08=(a06*a07);
  a09=(a04+a08);
  a10=arg[3]? arg[3][0] : 0;
  a11=arg[2]? arg[2][1] : 0;
  a12=(a10*a11);
  a13=arg[3]? arg[3][2] : 0;
  a14=arg[2]? arg[2][3] : 0;
  a15=(a13*a14);
  a12=(a12+a15);
  a15=arg[3]? arg[3][1] : 0;
  a16=arg[2]? arg[2][0] : 0;
  a17=(a15*a16);
  a12=(a12-a17);
  a17=arg[3]? arg[3][3] : 0;
  a18=arg[2]? arg[2][2] : 0;
  a19=(a17*a18);
  a12=(a12-a19);
  a19=(2.*a12);
  a20=(a10*a14);
  a21=(a15*a18);
  a20=(a20+a21);
  a21=(a13*a11);
  a20=(a20-a21);
  a21=(a17*a16);
  a20=(a20-a21);
  a21=(a19*a20);
  a22=(a10*a16);
  a23=(a15*a11);
  a22=(a22+a23);
  a23=(a13*a18);
  a22=(a22+a23);
  a23=(a17*a14);
  a22=(a22+a23);
  a23=(2.*a22);
  a10=(a10*a18);
  a17=(a17*a11);
  a10=(a10+a17);
  a15=(a15*a14);
  a10=(a10-a15);
  a13=(a13*a16);
  a10=(a10-a13);
  a13=(a23*a10);
  a15=(a21-a13);
  a17=(a09*a15);
  a17=(a00*a17);
  a01=casadi_sq(a01);
  a24=casadi_sq(a07);
  a25=(a01-a24);
  a26=casadi_sq(a05);
  a27=(a25+a26);
  a28=casadi_sq(a03);
  a27=(a27-a28);
  a29=(a23*a12);
  a30=(2.*a20);
  a30=(a30*a10);
  a31=(a29+a30);
  a32=(a27*a31);
  a32=(a00*a32);
  a17=(a17+a32);
  a06=(a06*a03);
  a32=(a02*a07);
  a33=(a06-a32);
  a34=casadi_sq(a20);
  a35=casadi_sq(a10);
  a36=(a34-a35);
  a22=casadi_sq(a22);
  a12=casadi_sq(a12);
  a37=(a22-a12);
  a36=(a36+a37);
  a38=(a33*a36);
  a38=(a00*a38);
  a17=(a17+a38);
  a38=arg[6]? arg[6][0] : 0;
  a39=arg[4]? arg[4][0] : 0;
  a40=casadi_sq(a11);
  a41=casadi_sq(a18);
  a42=(a40-a41);
  a43=casadi_sq(a16);
  a44=casadi_sq(a14);
  a45=(a43-a44);
  a42=(a42+a45);
  a42=(a39*a42);
  a46=arg[4]? arg[4][1] : 0;
  a47=(2.*a11);
  a48=(a47*a18);
  a16=(2.*a16);
  a49=(a16*a14);
  a50=(a48-a49);
  a50=(a46*a50);
  a42=(a42+a50);
  a50=arg[4]? arg[4][2] : 0;
  a51=(a16*a18);
  a47=(a47*a14);
  a52=(a51+a47);
  a52=(a50*a52);
  a42=(a42+a52);
  a52=arg[1]? arg[1][1] : 0;
  a53=arg[0]? arg[0][2] : 0;
  a54=6378137.;
  a55=1.;
  a56=6.6943799901413173e-03;
  a57=arg[0]? arg[0][0] : 0;
  a58=sin(a57);
  a59=casadi_sq(a58);
  a56=(a56*a59);
  a55=(a55-a56);
  a56=sqrt(a55);
  a54=(a54/a56);
  a54=(a53+a54);
  a52=(a52/a54);
  a54=7.2921149999999999e-05;
  a57=cos(a57);
  a59=(a54*a57);
  a59=(a52+a59);
  a42=(a42-a59);
  a42=(a38*a42);
  a17=(a17-a42);
  a07=(2.*a07);
  a07=(a07*a03);
  a02=(a02*a05);
  a05=(a07-a02);
  a23=(a23*a20);
  a19=(a19*a10);
  a10=(a23+a19);
  a20=(a05*a10);
  a20=(a00*a20);
  a17=(a17-a20);
  a32=(a32+a06);
  a37=(a35+a37);
  a37=(a37-a34);
  a06=(a32*a37);
  a06=(a00*a06);
  a17=(a17-a06);
  a25=(a25-a26);
  a25=(a25+a28);
  a30=(a30-a29);
  a29=(a25*a30);
  a29=(a00*a29);
  a17=(a17-a29);
  if (res[0]!=0) res[0][0]=a17;
  a22=(a22-a35);
  a22=(a22+a12);
  a22=(a22-a34);
  a05=(a05*a22);
  a05=(a00*a05);
  a19=(a19-a23);
  a32=(a32*a19);
  a32=(a00*a32);
  a05=(a05+a32);
  a13=(a13+a21);
  a25=(a25*a13);
  a25=(a00*a25);
  a05=(a05+a25);
  a49=(a49+a48);
  a49=(a39*a49);
  a45=(a41+a45);
  a45=(a45-a40);
  a45=(a46*a45);
  a49=(a49+a45);
  a18=(2.*a18);
  a18=(a18*a14);
  a16=(a16*a11);
  a11=(a18-a16);
  a11=(a50*a11);
  a49=(a49+a11);
  a11=arg[1]? arg[1][0] : 0;
  a14=6.3354393272928204e+06;
  a55=(a55*a56);
  a14=(a14/a55);
  a53=(a53+a14);
  a11=(a11/a53);
  a49=(a49+a11);
  a49=(a38*a49);
  a05=(a05-a49);
  a26=(a26+a28);
  a01=(a01-a26);
  a01=(a01+a24);
  a15=(a01*a15);
  a15=(a00*a15);
  a05=(a05-a15);
  a08=(a08-a04);
  a31=(a08*a31);
  a31=(a00*a31);
  a05=(a05-a31);
  a02=(a02+a07);
  a36=(a02*a36);
  a36=(a00*a36);
  a05=(a05-a36);
  if (res[0]!=0) res[0][1]=a05;
  a01=(a01*a10);
  a01=(a00*a01);
  a08=(a08*a37);
  a08=(a00*a08);
  a01=(a01+a08);
  a02=(a02*a30);
  a02=(a00*a02);
  a01=(a01+a02);
  a47=(a47-a51);
  a39=(a39*a47);
  a16=(a16+a18);
  a46=(a46*a16);
  a39=(a39+a46);
  a43=(a43-a41);
  a43=(a43+a44);
  a43=(a43-a40);
  a50=(a50*a43);
  a39=(a39+a50);
  a57=(a58/a57);
  a52=(a52*a57);
  a54=(a54*a58);
  a52=(a52+a54);
  a39=(a39+a52);
  a38=(a38*a39);
  a01=(a01-a38);
  a09=(a09*a22);
  a09=(a00*a09);
  a01=(a01-a09);
  a27=(a27*a19);
  a27=(a00*a27);
  a01=(a01-a27);
  a33=(a33*a13);
  a00=(a00*a33);
  a01=(a01-a00);
  if (res[0]!=0) res[0][2]=a01;
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


