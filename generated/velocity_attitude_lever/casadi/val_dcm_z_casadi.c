/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) val_dcm_z_casadi__ ## ID
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

/* val_dcm_z_casadi:(position[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],q_m2n_wxyz[4],lag)->(out_z[3]) */
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
  a08=(a04+a08);
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
  a19=(a19-a14);
  a12=(a08*a19);
  a12=(a00*a12);
  a16=(a05*a03);
  a16=(2.*a16);
  a22=(a02*a07);
  a16=(a16-a22);
  a23=casadi_sq(a11);
  a24=casadi_sq(a09);
  a25=(a23-a24);
  a20=casadi_sq(a20);
  a26=casadi_sq(a18);
  a27=(a20-a26);
  a25=(a25+a27);
  a28=(a16*a25);
  a28=(a00*a28);
  a12=(a12+a28);
  a28=casadi_sq(a05);
  a01=casadi_sq(a01);
  a29=casadi_sq(a07);
  a30=(a01-a29);
  a31=(a28+a30);
  a32=casadi_sq(a03);
  a31=(a31-a32);
  a33=(a21*a18);
  a34=(2.*a11);
  a35=(a09*a34);
  a35=(a33+a35);
  a36=(a31*a35);
  a36=(a00*a36);
  a12=(a12+a36);
  a36=arg[6]? arg[6][0] : 0;
  a37=arg[4]? arg[4][0] : 0;
  a38=casadi_sq(a15);
  a39=casadi_sq(a13);
  a40=(a38-a39);
  a41=casadi_sq(a17);
  a42=casadi_sq(a10);
  a43=(a41-a42);
  a40=(a40+a43);
  a40=(a37*a40);
  a44=arg[4]? arg[4][1] : 0;
  a45=(a15*a13);
  a45=(2.*a45);
  a17=(2.*a17);
  a46=(a17*a10);
  a45=(a45-a46);
  a45=(a44*a45);
  a40=(a40+a45);
  a45=arg[4]? arg[4][2] : 0;
  a47=(a17*a13);
  a48=(2.*a15);
  a49=(a48*a10);
  a49=(a47+a49);
  a49=(a45*a49);
  a40=(a40+a49);
  a49=arg[1]? arg[1][1] : 0;
  a50=arg[0]? arg[0][2] : 0;
  a51=6378137.;
  a52=1.;
  a53=6.6943799901413173e-03;
  a54=arg[0]? arg[0][0] : 0;
  a55=sin(a54);
  a56=casadi_sq(a55);
  a53=(a53*a56);
  a52=(a52-a53);
  a53=sqrt(a52);
  a51=(a51/a53);
  a51=(a50+a51);
  a49=(a49/a51);
  a40=(a40-a49);
  a51=7.2921149999999999e-05;
  a54=cos(a54);
  a56=(a51*a54);
  a40=(a40-a56);
  a40=(a36*a40);
  a12=(a12-a40);
  a21=(a11*a21);
  a40=(a18*a09);
  a40=(2.*a40);
  a56=(a21+a40);
  a57=(a07*a03);
  a57=(2.*a57);
  a02=(a02*a05);
  a58=(a57-a02);
  a59=(a56*a58);
  a59=(a00*a59);
  a12=(a12-a59);
  a27=(a24+a27);
  a27=(a27-a23);
  a06=(a06*a03);
  a22=(a22+a06);
  a06=(a27*a22);
  a06=(a00*a06);
  a12=(a12-a06);
  a11=(a11*a09);
  a11=(2.*a11);
  a11=(a11-a33);
  a33=(a32-a28);
  a33=(a33+a30);
  a30=(a11*a33);
  a30=(a00*a30);
  a12=(a12-a30);
  if (res[0]!=0) res[0][0]=a12;
  a20=(a20-a24);
  a20=(a20+a26);
  a20=(a20-a23);
  a58=(a58*a20);
  a58=(a00*a58);
  a40=(a40-a21);
  a22=(a22*a40);
  a22=(a00*a22);
  a58=(a58+a22);
  a18=(a18*a34);
  a14=(a14+a18);
  a33=(a33*a14);
  a33=(a00*a33);
  a58=(a58+a33);
  a48=(a48*a13);
  a46=(a46+a48);
  a46=(a37*a46);
  a48=(a39-a38);
  a48=(a48+a43);
  a48=(a44*a48);
  a46=(a46+a48);
  a13=(a13*a10);
  a13=(2.*a13);
  a17=(a17*a15);
  a48=(a13-a17);
  a48=(a45*a48);
  a46=(a46+a48);
  a48=arg[1]? arg[1][0] : 0;
  a43=6.3354393272928204e+06;
  a52=(a52*a53);
  a43=(a43/a52);
  a50=(a50+a43);
  a48=(a48/a50);
  a46=(a46+a48);
  a46=(a36*a46);
  a58=(a58-a46);
  a01=(a01-a28);
  a01=(a01+a29);
  a01=(a01-a32);
  a19=(a19*a01);
  a19=(a00*a19);
  a58=(a58-a19);
  a02=(a02+a57);
  a25=(a25*a02);
  a25=(a00*a25);
  a58=(a58-a25);
  a07=(a07*a05);
  a07=(2.*a07);
  a07=(a07-a04);
  a35=(a35*a07);
  a35=(a00*a35);
  a58=(a58-a35);
  if (res[0]!=0) res[0][1]=a58;
  a56=(a56*a01);
  a56=(a00*a56);
  a27=(a27*a07);
  a27=(a00*a27);
  a56=(a56+a27);
  a11=(a11*a02);
  a11=(a00*a11);
  a56=(a56+a11);
  a51=(a51*a55);
  a55=(a55/a54);
  a49=(a49*a55);
  a51=(a51+a49);
  a15=(a15*a10);
  a15=(2.*a15);
  a15=(a15-a47);
  a37=(a37*a15);
  a51=(a51+a37);
  a17=(a17+a13);
  a44=(a44*a17);
  a51=(a51+a44);
  a38=(a38+a39);
  a41=(a41-a38);
  a41=(a41+a42);
  a45=(a45*a41);
  a51=(a51+a45);
  a36=(a36*a51);
  a56=(a56-a36);
  a08=(a08*a20);
  a08=(a00*a08);
  a56=(a56-a08);
  a16=(a16*a14);
  a16=(a00*a16);
  a56=(a56-a16);
  a31=(a31*a40);
  a00=(a00*a31);
  a56=(a56-a00);
  if (res[0]!=0) res[0][2]=a56;
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
    case 0: return "position";
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


