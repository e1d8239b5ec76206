/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_velocity_exact_h_casadi__ ## ID
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
#define casadi_s3 CASADI_PREFIX(s3)
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
CASADI_SYMBOL_EXPORT void va_velocity_exact_h_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_velocity_exact_h_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_velocity_exact_h_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {16, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {4, 1, 1};
static const casadi_int casadi_s3[3] = {1, 1, 1};

/* va_velocity_exact_h_casadi:(x[16],position[3],v_n[3],q_b2n_wxyz[4],omega_ib_b[3],lever_b[3],a_n[3],lag)->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51;
  a00=arg[0]? arg[0][3] : 0;
  a01=arg[7]? arg[7][0] : 0;
  a02=arg[0]? arg[0][15] : 0;
  a02=(a01-a02);
  a03=arg[6]? arg[6][0] : 0;
  a04=(a02*a03);
  a00=(a00+a04);
  a04=arg[5]? arg[5][0] : 0;
  a05=arg[3]? arg[3][0] : 0;
  a06=(2.*a05);
  a07=arg[3]? arg[3][3] : 0;
  a08=(a06*a07);
  a09=arg[3]? arg[3][1] : 0;
  a10=(2.*a09);
  a11=arg[3]? arg[3][2] : 0;
  a12=(a10*a11);
  a12=(a08+a12);
  a13=7.2921149999999999e-05;
  a14=arg[1]? arg[1][0] : 0;
  a15=sin(a14);
  a16=(a13*a15);
  a17=arg[2]? arg[2][1] : 0;
  a18=arg[1]? arg[1][2] : 0;
  a19=6378137.;
  a20=1.;
  a21=6.6943799901413173e-03;
  a22=casadi_sq(a15);
  a21=(a21*a22);
  a20=(a20-a21);
  a21=sqrt(a20);
  a19=(a19/a21);
  a19=(a18+a19);
  a17=(a17/a19);
  a14=cos(a14);
  a15=(a15/a14);
  a15=(a17*a15);
  a16=(a16+a15);
  a15=(a12*a16);
  a19=(a09*a07);
  a19=(2.*a19);
  a22=(a06*a11);
  a19=(a19-a22);
  a23=arg[2]? arg[2][0] : 0;
  a24=6.3354393272928204e+06;
  a20=(a20*a21);
  a24=(a24/a20);
  a18=(a18+a24);
  a23=(a23/a18);
  a18=(a19*a23);
  a15=(a15-a18);
  a15=(a04*a15);
  a00=(a00+a15);
  a15=arg[0]? arg[0][8] : 0;
  a18=arg[4]? arg[4][2] : 0;
  a15=(a15+a18);
  a24=5.0000000000000000e-01;
  a20=1.0000000000000001e-30;
  a21=arg[0]? arg[0][2] : 0;
  a25=casadi_sq(a21);
  a20=(a20+a25);
  a25=arg[0]? arg[0][1] : 0;
  a26=casadi_sq(a25);
  a20=(a20+a26);
  a26=arg[0]? arg[0][0] : 0;
  a27=casadi_sq(a26);
  a20=(a20+a27);
  a20=sqrt(a20);
  a24=(a24*a20);
  a27=cos(a24);
  a28=(a27*a11);
  a24=sin(a24);
  a24=(a24/a20);
  a21=(a24*a21);
  a20=(a21*a09);
  a28=(a28+a20);
  a20=(a24*a25);
  a29=(a20*a05);
  a28=(a28+a29);
  a29=(a24*a26);
  a30=(a29*a07);
  a28=(a28-a30);
  a30=(a27*a09);
  a20=(a20*a07);
  a30=(a30+a20);
  a29=(a29*a05);
  a30=(a30+a29);
  a29=(a21*a11);
  a30=(a30-a29);
  a29=(a28*a30);
  a29=(2.*a29);
  a20=(a27*a07);
  a31=(a21*a05);
  a20=(a20+a31);
  a31=(a24*a11);
  a32=(a31*a26);
  a20=(a20+a32);
  a24=(a24*a09);
  a32=(a24*a25);
  a20=(a20-a32);
  a27=(a27*a05);
  a21=(a21*a07);
  a27=(a27-a21);
  a31=(a31*a25);
  a27=(a27-a31);
  a24=(a24*a26);
  a27=(a27-a24);
  a24=(2.*a27);
  a26=(a20*a24);
  a29=(a29-a26);
  a31=(a15*a29);
  a25=arg[0]? arg[0][7] : 0;
  a21=arg[4]? arg[4][1] : 0;
  a25=(a25+a21);
  a32=(2.*a30);
  a33=(a20*a32);
  a34=(a28*a24);
  a35=(a33+a34);
  a36=(a25*a35);
  a31=(a31-a36);
  a31=(a04*a31);
  a00=(a00+a31);
  a31=arg[5]? arg[5][1] : 0;
  a05=casadi_sq(a05);
  a36=casadi_sq(a09);
  a37=(a05-a36);
  a38=casadi_sq(a07);
  a39=(a37-a38);
  a40=casadi_sq(a11);
  a39=(a39+a40);
  a41=(a16*a39);
  a06=(a06*a09);
  a42=(a11*a07);
  a42=(2.*a42);
  a43=(a06+a42);
  a44=(a23*a43);
  a41=(a41-a44);
  a41=(a31*a41);
  a00=(a00+a41);
  a41=arg[0]? arg[0][6] : 0;
  a44=arg[4]? arg[4][0] : 0;
  a41=(a41+a44);
  a45=(a35*a41);
  a46=casadi_sq(a28);
  a47=casadi_sq(a30);
  a48=(a46-a47);
  a49=casadi_sq(a20);
  a27=casadi_sq(a27);
  a50=(a49-a27);
  a48=(a48+a50);
  a51=(a15*a48);
  a45=(a45+a51);
  a45=(a31*a45);
  a00=(a00+a45);
  a45=arg[5]? arg[5][2] : 0;
  a42=(a42-a06);
  a06=(a16*a42);
  a51=(a38-a40);
  a51=(a51+a37);
  a37=(a23*a51);
  a06=(a06-a37);
  a06=(a45*a06);
  a00=(a00+a06);
  a06=(a29*a41);
  a37=(a25*a48);
  a06=(a06+a37);
  a06=(a45*a06);
  a00=(a00-a06);
  a03=(a03*a01);
  a00=(a00-a03);
  a32=(a28*a32);
  a26=(a26+a32);
  a32=(a16*a26);
  a33=(a33-a34);
  a34=(a23*a33);
  a32=(a32-a34);
  a32=(a04*a32);
  a00=(a00-a32);
  a09=(a09*a11);
  a09=(2.*a09);
  a09=(a09-a08);
  a08=(a09*a18);
  a10=(a10*a07);
  a22=(a22+a10);
  a10=(a22*a21);
  a08=(a08-a10);
  a08=(a04*a08);
  a00=(a00-a08);
  a50=(a47+a50);
  a50=(a50-a46);
  a08=(a16*a50);
  a28=(a28*a20);
  a28=(2.*a28);
  a30=(a30*a24);
  a24=(a28+a30);
  a20=(a23*a24);
  a08=(a08+a20);
  a08=(a31*a08);
  a00=(a00+a08);
  a08=(a22*a44);
  a40=(a40+a38);
  a05=(a05-a40);
  a05=(a05+a36);
  a36=(a05*a18);
  a08=(a08-a36);
  a08=(a31*a08);
  a00=(a00-a08);
  a08=(a05*a21);
  a36=(a09*a44);
  a08=(a08-a36);
  a08=(a45*a08);
  a00=(a00-a08);
  a28=(a28-a30);
  a30=(a16*a28);
  a49=(a49-a47);
  a49=(a49+a27);
  a49=(a49-a46);
  a46=(a23*a49);
  a30=(a30-a46);
  a30=(a45*a30);
  a00=(a00-a30);
  if (res[0]!=0) res[0][0]=a00;
  a00=arg[0]? arg[0][4] : 0;
  a30=arg[6]? arg[6][1] : 0;
  a46=(a02*a30);
  a00=(a00+a46);
  a46=(a05*a16);
  a13=(a13*a14);
  a17=(a17+a13);
  a13=(a19*a17);
  a46=(a46+a13);
  a46=(a04*a46);
  a00=(a00-a46);
  a46=(a15*a50);
  a13=(a25*a28);
  a46=(a46+a13);
  a46=(a04*a46);
  a00=(a00-a46);
  a46=(a43*a17);
  a13=(a09*a16);
  a46=(a46+a13);
  a46=(a31*a46);
  a00=(a00-a46);
  a46=(a41*a28);
  a13=(a15*a26);
  a46=(a46-a13);
  a46=(a31*a46);
  a00=(a00+a46);
  a46=(a51*a17);
  a13=(a22*a16);
  a46=(a46+a13);
  a46=(a45*a46);
  a00=(a00-a46);
  a46=(a25*a26);
  a13=(a41*a50);
  a46=(a46+a13);
  a46=(a45*a46);
  a00=(a00+a46);
  a30=(a30*a01);
  a00=(a00-a30);
  a30=(a39*a18);
  a46=(a42*a21);
  a30=(a30-a46);
  a30=(a04*a30);
  a00=(a00-a30);
  a30=(a48*a16);
  a46=(a33*a17);
  a30=(a30-a46);
  a30=(a04*a30);
  a00=(a00-a30);
  a30=(a42*a44);
  a46=(a12*a18);
  a30=(a30-a46);
  a30=(a31*a30);
  a00=(a00-a30);
  a30=(a29*a16);
  a46=(a24*a17);
  a30=(a30+a46);
  a30=(a31*a30);
  a00=(a00+a30);
  a30=(a12*a21);
  a46=(a39*a44);
  a30=(a30-a46);
  a30=(a45*a30);
  a00=(a00-a30);
  a16=(a35*a16);
  a30=(a49*a17);
  a16=(a16+a30);
  a16=(a45*a16);
  a00=(a00+a16);
  if (res[0]!=0) res[0][1]=a00;
  a00=arg[0]? arg[0][5] : 0;
  a16=arg[6]? arg[6][2] : 0;
  a02=(a02*a16);
  a00=(a00+a02);
  a05=(a05*a23);
  a12=(a12*a17);
  a05=(a05+a12);
  a05=(a04*a05);
  a00=(a00+a05);
  a05=(a15*a24);
  a12=(a25*a49);
  a05=(a05-a12);
  a05=(a04*a05);
  a00=(a00+a05);
  a09=(a23*a09);
  a39=(a39*a17);
  a09=(a09+a39);
  a09=(a31*a09);
  a00=(a00+a09);
  a49=(a41*a49);
  a15=(a15*a33);
  a49=(a49-a15);
  a49=(a31*a49);
  a00=(a00+a49);
  a22=(a23*a22);
  a42=(a42*a17);
  a22=(a22+a42);
  a22=(a45*a22);
  a00=(a00+a22);
  a25=(a25*a33);
  a41=(a41*a24);
  a25=(a25-a41);
  a25=(a45*a25);
  a00=(a00+a25);
  a16=(a16*a01);
  a00=(a00-a16);
  a26=(a26*a17);
  a48=(a23*a48);
  a26=(a26-a48);
  a26=(a04*a26);
  a00=(a00-a26);
  a26=(a43*a18);
  a48=(a51*a21);
  a26=(a26-a48);
  a04=(a04*a26);
  a00=(a00-a04);
  a29=(a23*a29);
  a50=(a50*a17);
  a29=(a29-a50);
  a29=(a31*a29);
  a00=(a00-a29);
  a51=(a51*a44);
  a18=(a19*a18);
  a51=(a51-a18);
  a31=(a31*a51);
  a00=(a00-a31);
  a19=(a19*a21);
  a43=(a43*a44);
  a19=(a19-a43);
  a19=(a45*a19);
  a00=(a00-a19);
  a23=(a23*a35);
  a28=(a28*a17);
  a23=(a23+a28);
  a45=(a45*a23);
  a00=(a00-a45);
  if (res[0]!=0) res[0][2]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_velocity_exact_h_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_velocity_exact_h_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_velocity_exact_h_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_velocity_exact_h_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_velocity_exact_h_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_velocity_exact_h_casadi_n_in(void) { return 8;}

CASADI_SYMBOL_EXPORT casadi_int va_velocity_exact_h_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real va_velocity_exact_h_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_velocity_exact_h_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "position";
    case 2: return "v_n";
    case 3: return "q_b2n_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "lever_b";
    case 6: return "a_n";
    case 7: return "lag";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_velocity_exact_h_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_velocity_exact_h_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    case 4: return casadi_s1;
    case 5: return casadi_s1;
    case 6: return casadi_s1;
    case 7: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_velocity_exact_h_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_velocity_exact_h_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_velocity_exact_h_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


