/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) em_euler_exact_h_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void em_euler_exact_h_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {6, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};

/* em_euler_exact_h_casadi:(x[6],mu[3],euler_b[3])->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63;
  a00=arg[2]? arg[2][0] : 0;
  a01=cos(a00);
  a02=arg[2]? arg[2][1] : 0;
  a03=cos(a02);
  a04=(a01*a03);
  a05=2.;
  a06=1.0000000000000001e-30;
  a07=arg[1]? arg[1][0] : 0;
  a08=(a07*a07);
  a09=(a06+a08);
  a10=arg[1]? arg[1][1] : 0;
  a11=(a10*a10);
  a09=(a09+a11);
  a12=arg[1]? arg[1][2] : 0;
  a13=(a12*a12);
  a09=(a09+a13);
  a14=sqrt(a09);
  a15=5.0000000000000000e-01;
  a16=(a14*a15);
  a17=sin(a16);
  a18=(a17*a17);
  a19=(a05*a18);
  a20=1.;
  a09=(a20/a09);
  a19=(a19*a09);
  a19=(a19*a10);
  a19=(a19*a12);
  a21=(a05*a07);
  a16=cos(a16);
  a17=(a16*a17);
  a17=(a17/a14);
  a14=(a21*a17);
  a19=(a19-a14);
  a19=(a04*a19);
  a00=sin(a00);
  a22=(a03*a00);
  a18=(a18*a09);
  a13=(a18*a13);
  a11=(a18*a11);
  a09=(a13-a11);
  a08=(a18*a08);
  a16=(a16*a16);
  a23=(a08-a16);
  a09=(a09+a23);
  a09=(a22*a09);
  a19=(a19-a09);
  a02=sin(a02);
  a09=(a18*a10);
  a24=(a21*a09);
  a25=(a05*a12);
  a26=(a25*a17);
  a27=(a24+a26);
  a27=(a02*a27);
  a19=(a19-a27);
  a09=(a09*a25);
  a14=(a14+a09);
  a14=(a22*a14);
  a23=(a11+a23);
  a23=(a23-a13);
  a23=(a04*a23);
  a14=(a14-a23);
  a21=(a21*a18);
  a21=(a21*a12);
  a17=(a05*a17);
  a17=(a17*a10);
  a18=(a21-a17);
  a18=(a02*a18);
  a14=(a14-a18);
  a19=atan2(a19,a14);
  a14=arg[0]? arg[0][1] : 0;
  a18=(a05*a14);
  a23=arg[0]? arg[0][2] : 0;
  a09=(a23*a23);
  a25=(a06+a09);
  a27=(a14*a14);
  a25=(a25+a27);
  a28=arg[0]? arg[0][0] : 0;
  a29=(a28*a28);
  a25=(a25+a29);
  a30=sqrt(a25);
  a31=(a30*a15);
  a32=sin(a31);
  a33=(a32*a32);
  a25=(a20/a25);
  a34=(a33*a25);
  a35=(a34*a23);
  a36=(a18*a35);
  a31=cos(a31);
  a32=(a32*a31);
  a32=(a32/a30);
  a30=(a05*a28);
  a37=(a32*a30);
  a38=(a36+a37);
  a39=arg[2]? arg[2][2] : 0;
  a40=sin(a39);
  a41=(a03*a40);
  a42=(a38*a41);
  a35=(a35*a30);
  a30=(a18*a32);
  a43=(a35-a30);
  a39=cos(a39);
  a44=(a03*a39);
  a45=(a43*a44);
  a42=(a42+a45);
  a31=(a31*a31);
  a29=(a29*a34);
  a45=(a31-a29);
  a09=(a09*a34);
  a27=(a27*a34);
  a46=(a09-a27);
  a45=(a45+a46);
  a47=(a02*a45);
  a42=(a42-a47);
  a47=arg[0]? arg[0][4] : 0;
  a47=(a47-a10);
  a10=arg[0]? arg[0][3] : 0;
  a10=(a10-a07);
  a07=(a10*a10);
  a06=(a06+a07);
  a48=(a47*a47);
  a06=(a06+a48);
  a49=arg[0]? arg[0][5] : 0;
  a49=(a49-a12);
  a12=(a49*a49);
  a06=(a06+a12);
  a50=sqrt(a06);
  a15=(a50*a15);
  a51=sin(a15);
  a52=(a51*a51);
  a20=(a20/a06);
  a06=(a52*a20);
  a53=(a47*a06);
  a54=(a05*a10);
  a55=(a53*a54);
  a56=(a05*a49);
  a15=cos(a15);
  a51=(a51*a15);
  a51=(a51/a50);
  a50=(a56*a51);
  a57=(a55-a50);
  a57=(a42*a57);
  a58=(a01*a39);
  a59=(a00*a40);
  a60=(a02*a59);
  a60=(a58+a60);
  a61=(a60*a38);
  a39=(a00*a39);
  a62=(a02*a39);
  a63=(a01*a40);
  a62=(a62-a63);
  a63=(a62*a43);
  a61=(a61+a63);
  a03=(a03*a45);
  a00=(a00*a03);
  a61=(a61+a00);
  a12=(a12*a06);
  a48=(a48*a06);
  a00=(a12-a48);
  a07=(a07*a06);
  a15=(a15*a15);
  a45=(a07-a15);
  a00=(a00+a45);
  a00=(a61*a00);
  a57=(a57-a00);
  a03=(a01*a03);
  a01=(a02*a01);
  a01=(a01*a40);
  a01=(a01-a39);
  a38=(a38*a01);
  a03=(a03+a38);
  a58=(a02*a58);
  a59=(a59+a58);
  a43=(a43*a59);
  a03=(a03+a43);
  a54=(a54*a51);
  a53=(a53*a56);
  a53=(a54+a53);
  a53=(a03*a53);
  a57=(a57+a53);
  a47=(a05*a47);
  a49=(a47*a49);
  a49=(a49*a20);
  a49=(a49*a52);
  a49=(a49-a54);
  a49=(a61*a49);
  a10=(a10*a06);
  a10=(a10*a56);
  a47=(a47*a51);
  a51=(a10+a47);
  a51=(a42*a51);
  a49=(a49+a51);
  a51=(a48-a12);
  a51=(a51+a45);
  a51=(a03*a51);
  a49=(a49-a51);
  a57=atan2(a57,a49);
  a19=(a19-a57);
  a57=sin(a19);
  a19=cos(a19);
  a57=atan2(a57,a19);
  if (res[0]!=0) res[0][0]=a57;
  a55=(a55+a50);
  a61=(a61*a55);
  a10=(a10-a47);
  a03=(a10*a03);
  a61=(a61+a03);
  a12=(a12+a48);
  a15=(a15-a12);
  a15=(a15+a07);
  a42=(a15*a42);
  a61=(a61+a42);
  a61=(-a61);
  a25=(a05*a25);
  a25=(a25*a33);
  a25=(a25*a14);
  a25=(a25*a28);
  a05=(a05*a32);
  a05=(a05*a23);
  a25=(a25-a05);
  a23=(a60*a25);
  a32=(a31+a29);
  a09=(a09-a32);
  a09=(a09+a27);
  a27=(a62*a09);
  a23=(a23-a27);
  a35=(a35+a30);
  a30=(a35*a22);
  a23=(a23+a30);
  a23=(a55*a23);
  a30=(a35*a04);
  a27=(a25*a01);
  a30=(a30+a27);
  a27=(a09*a59);
  a30=(a30-a27);
  a30=(a10*a30);
  a23=(a23+a30);
  a25=(a25*a41);
  a09=(a09*a44);
  a25=(a25-a09);
  a35=(a02*a35);
  a25=(a25-a35);
  a25=(a15*a25);
  a23=(a23+a25);
  a25=(a23*a23);
  a18=(a18*a34);
  a18=(a18*a28);
  a05=(a05+a18);
  a18=(a62*a05);
  a29=(a29-a31);
  a29=(a29+a46);
  a46=(a60*a29);
  a18=(a18-a46);
  a36=(a36-a37);
  a37=(a36*a22);
  a18=(a18+a37);
  a55=(a55*a18);
  a18=(a36*a04);
  a37=(a05*a59);
  a18=(a18+a37);
  a37=(a29*a01);
  a18=(a18-a37);
  a10=(a10*a18);
  a55=(a55+a10);
  a05=(a05*a44);
  a29=(a29*a41);
  a05=(a05-a29);
  a36=(a02*a36);
  a05=(a05-a36);
  a15=(a15*a05);
  a55=(a55+a15);
  a15=(a55*a55);
  a25=(a25+a15);
  a25=sqrt(a25);
  a61=atan2(a61,a25);
  a16=(a16-a11);
  a16=(a16+a08);
  a16=(a16-a13);
  a02=(a02*a16);
  a24=(a24-a26);
  a22=(a24*a22);
  a02=(a02-a22);
  a21=(a21+a17);
  a04=(a21*a04);
  a02=(a02-a04);
  a62=(a62*a24);
  a59=(a21*a59);
  a62=(a62+a59);
  a44=(a16*a44);
  a62=(a62+a44);
  a44=(a62*a62);
  a60=(a60*a24);
  a21=(a21*a01);
  a60=(a60+a21);
  a16=(a16*a41);
  a60=(a60+a16);
  a16=(a60*a60);
  a44=(a44+a16);
  a44=sqrt(a44);
  a02=atan2(a02,a44);
  a61=(a61-a02);
  a02=sin(a61);
  a02=(-a02);
  a61=cos(a61);
  a02=atan2(a02,a61);
  if (res[0]!=0) res[0][1]=a02;
  a60=atan2(a60,a62);
  a55=atan2(a55,a23);
  a60=(a60-a55);
  a55=sin(a60);
  a60=cos(a60);
  a55=atan2(a55,a60);
  if (res[0]!=0) res[0][2]=a55;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void em_euler_exact_h_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void em_euler_exact_h_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void em_euler_exact_h_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int em_euler_exact_h_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int em_euler_exact_h_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real em_euler_exact_h_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_euler_exact_h_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "mu";
    case 2: return "euler_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_euler_exact_h_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_euler_exact_h_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_euler_exact_h_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


