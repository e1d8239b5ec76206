/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_velocity_exact_H_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void va_velocity_exact_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_velocity_exact_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_velocity_exact_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {16, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {4, 1, 1};
static const casadi_int casadi_s3[3] = {24, 1, 1};

/* va_velocity_exact_H_casadi:(x[16],position[3],v_n[3],q_b2n_wxyz[4],omega_ib_b[3],lever_b[3],a_n[3])->(out_H[24]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61;
  a00=5.0000000000000000e-01;
  a01=1.0000000000000001e-30;
  a02=arg[0]? arg[0][2] : 0;
  a03=(a02*a02);
  a01=(a01+a03);
  a03=arg[0]? arg[0][1] : 0;
  a04=(a03*a03);
  a01=(a01+a04);
  a04=arg[0]? arg[0][0] : 0;
  a05=(a04*a04);
  a01=(a01+a05);
  a01=sqrt(a01);
  a05=(a00*a01);
  a06=sin(a05);
  a07=1.;
  a08=(a07/a01);
  a09=(a06*a08);
  a10=arg[3]? arg[3][2] : 0;
  a11=(a09*a10);
  a05=cos(a05);
  a12=(a05*a10);
  a13=(a09*a02);
  a14=arg[3]? arg[3][1] : 0;
  a15=(a13*a14);
  a12=(a12+a15);
  a15=(a09*a03);
  a16=arg[3]? arg[3][0] : 0;
  a17=(a15*a16);
  a12=(a12+a17);
  a17=(a09*a04);
  a18=arg[3]? arg[3][3] : 0;
  a19=(a17*a18);
  a12=(a12-a19);
  a19=2.;
  a20=arg[2]? arg[2][0] : 0;
  a21=arg[1]? arg[1][2] : 0;
  a22=6.3354393272928204e+06;
  a23=6.6943799901413173e-03;
  a24=arg[1]? arg[1][0] : 0;
  a25=sin(a24);
  a26=(a25*a25);
  a23=(a23*a26);
  a23=(a07-a23);
  a26=sqrt(a23);
  a23=(a23*a26);
  a22=(a22/a23);
  a22=(a21+a22);
  a20=(a20/a22);
  a22=arg[5]? arg[5][1] : 0;
  a23=(a20*a22);
  a27=7.2921149999999999e-05;
  a28=(a27*a25);
  a29=arg[2]? arg[2][1] : 0;
  a30=6378137.;
  a30=(a30/a26);
  a21=(a21+a30);
  a29=(a29/a21);
  a24=cos(a24);
  a25=(a25/a24);
  a25=(a29*a25);
  a28=(a28+a25);
  a25=arg[5]? arg[5][2] : 0;
  a21=(a28*a25);
  a30=(a23-a21);
  a30=(a19*a30);
  a26=(a12*a30);
  a31=(a05*a18);
  a32=(a13*a16);
  a31=(a31+a32);
  a32=(a11*a04);
  a31=(a31+a32);
  a32=(a09*a14);
  a33=(a32*a03);
  a31=(a31-a33);
  a33=(a19*a31);
  a34=(a20*a25);
  a35=(a28*a22);
  a36=arg[0]? arg[0][8] : 0;
  a37=arg[4]? arg[4][2] : 0;
  a36=(a36+a37);
  a37=(a36*a22);
  a38=arg[0]? arg[0][7] : 0;
  a39=arg[4]? arg[4][1] : 0;
  a38=(a38+a39);
  a39=(a38*a25);
  a40=(a37-a39);
  a41=(a35+a40);
  a42=(a34+a41);
  a42=(a33*a42);
  a26=(a26+a42);
  a42=(a05*a14);
  a15=(a15*a18);
  a42=(a42+a15);
  a17=(a17*a16);
  a42=(a42+a17);
  a17=(a13*a10);
  a42=(a42-a17);
  a17=(a19*a42);
  a15=arg[5]? arg[5][0] : 0;
  a20=(a20*a15);
  a43=arg[0]? arg[0][6] : 0;
  a44=arg[4]? arg[4][0] : 0;
  a43=(a43+a44);
  a44=(a43*a22);
  a38=(a38*a15);
  a44=(a44-a38);
  a38=(a20+a44);
  a45=(a17*a38);
  a26=(a26+a45);
  a45=(a05*a16);
  a13=(a13*a18);
  a45=(a45-a13);
  a13=(a11*a03);
  a45=(a45-a13);
  a13=(a32*a04);
  a45=(a45-a13);
  a13=(a19*a45);
  a28=(a28*a15);
  a36=(a36*a15);
  a43=(a43*a25);
  a46=(a36-a43);
  a47=(a28+a46);
  a48=(a13*a47);
  a26=(a26-a48);
  a48=(a11*a26);
  a41=(a34-a41);
  a41=(a13*a41);
  a49=(a21+a23);
  a50=(a42*a49);
  a51=(a44-a20);
  a52=(a12*a51);
  a50=(a50+a52);
  a47=(a31*a47);
  a50=(a50-a47);
  a50=(a19*a50);
  a41=(a41+a50);
  a50=(a32*a41);
  a48=(a48-a50);
  a49=(a13*a49);
  a50=(a35-a34);
  a50=(a50-a40);
  a50=(a17*a50);
  a49=(a49+a50);
  a38=(a31*a38);
  a50=(a12*a28);
  a38=(a38-a50);
  a38=(a19*a38);
  a49=(a49+a38);
  a38=(a19*a46);
  a50=(a12*a38);
  a49=(a49+a50);
  a50=(a16*a49);
  a30=(a31*a30);
  a47=(a17*a28);
  a30=(a30-a47);
  a47=(a19*a12);
  a52=(a34+a35);
  a40=(a40-a52);
  a40=(a47*a40);
  a30=(a30+a40);
  a51=(a13*a51);
  a30=(a30+a51);
  a38=(a42*a38);
  a30=(a30+a38);
  a38=(a18*a30);
  a50=(a50-a38);
  a38=(a09*a50);
  a48=(a48+a38);
  a38=(a19*a04);
  a51=(a04*a26);
  a40=(a03*a41);
  a51=(a51-a40);
  a51=(a10*a51);
  a40=(a04*a41);
  a52=(a03*a26);
  a40=(a40+a52);
  a40=(a14*a40);
  a51=(a51-a40);
  a50=(a04*a50);
  a51=(a51+a50);
  a50=(a18*a49);
  a40=(a16*a30);
  a50=(a50+a40);
  a40=(a03*a50);
  a51=(a51+a40);
  a40=(a16*a26);
  a52=(a18*a41);
  a40=(a40-a52);
  a52=(a10*a49);
  a40=(a40-a52);
  a52=(a14*a30);
  a40=(a40+a52);
  a52=(a02*a40);
  a51=(a51+a52);
  a52=(a51*a08);
  a52=(a05*a52);
  a53=(a16*a41);
  a54=(a18*a26);
  a53=(a53+a54);
  a49=(a14*a49);
  a53=(a53+a49);
  a30=(a10*a30);
  a53=(a53+a30);
  a53=(a06*a53);
  a52=(a52-a53);
  a52=(a00*a52);
  a53=(a09*a08);
  a51=(a53*a51);
  a52=(a52-a51);
  a01=(a19*a01);
  a01=(a07/a01);
  a52=(a52*a01);
  a51=(a38*a52);
  a48=(a48+a51);
  if (res[0]!=0) res[0][0]=a48;
  a50=(a09*a50);
  a41=(a11*a41);
  a26=(a32*a26);
  a41=(a41+a26);
  a50=(a50-a41);
  a41=(a19*a03);
  a26=(a41*a52);
  a50=(a50+a26);
  if (res[0]!=0) res[0][1]=a50;
  a40=(a09*a40);
  a50=(a19*a02);
  a52=(a50*a52);
  a40=(a40+a52);
  if (res[0]!=0) res[0][2]=a40;
  if (res[0]!=0) res[0][3]=a07;
  a40=(a31*a17);
  a52=(a12*a13);
  a26=(a40+a52);
  a48=(a26*a22);
  a51=(a12*a42);
  a51=(a19*a51);
  a30=(a31*a13);
  a51=(a51-a30);
  a49=(a51*a25);
  a48=(a48-a49);
  if (res[0]!=0) res[0][4]=a48;
  a48=(a12*a12);
  a49=(a42*a42);
  a54=(a48-a49);
  a55=(a31*a31);
  a45=(a45*a45);
  a56=(a55-a45);
  a54=(a54+a56);
  a57=(a54*a25);
  a26=(a26*a15);
  a57=(a57+a26);
  a57=(-a57);
  if (res[0]!=0) res[0][5]=a57;
  a54=(a54*a22);
  a51=(a51*a15);
  a54=(a54+a51);
  if (res[0]!=0) res[0][6]=a54;
  a54=arg[6]? arg[6][0] : 0;
  a54=(-a54);
  if (res[0]!=0) res[0][7]=a54;
  a27=(a27*a24);
  a29=(a29+a27);
  a27=(a29*a22);
  a24=(a44+a27);
  a54=(a19*a24);
  a51=(a12*a54);
  a57=(a29*a25);
  a43=(a43-a36);
  a36=(a43-a28);
  a26=(a57+a36);
  a26=(a33*a26);
  a51=(a51+a26);
  a29=(a29*a15);
  a26=(a29+a21);
  a58=(a17*a26);
  a51=(a51+a58);
  a39=(a39-a37);
  a37=(a39-a35);
  a58=(a13*a37);
  a51=(a51+a58);
  a58=(a11*a51);
  a36=(a57-a36);
  a36=(a13*a36);
  a59=(a27-a44);
  a60=(a42*a59);
  a21=(a21-a29);
  a61=(a12*a21);
  a60=(a60+a61);
  a37=(a31*a37);
  a60=(a60+a37);
  a60=(a19*a60);
  a36=(a36+a60);
  a60=(a32*a36);
  a58=(a58-a60);
  a60=(a13*a59);
  a37=(a43-a57);
  a37=(a37+a28);
  a37=(a17*a37);
  a60=(a60+a37);
  a37=(a12*a39);
  a26=(a31*a26);
  a37=(a37+a26);
  a37=(a19*a37);
  a60=(a60+a37);
  a35=(a19*a35);
  a37=(a12*a35);
  a60=(a60+a37);
  a37=(a16*a60);
  a54=(a31*a54);
  a26=(a17*a39);
  a54=(a54+a26);
  a43=(a57+a43);
  a43=(a43+a28);
  a43=(a47*a43);
  a54=(a54-a43);
  a21=(a13*a21);
  a54=(a54+a21);
  a35=(a42*a35);
  a54=(a54+a35);
  a35=(a18*a54);
  a37=(a37-a35);
  a35=(a09*a37);
  a58=(a58+a35);
  a35=(a04*a51);
  a21=(a03*a36);
  a35=(a35-a21);
  a35=(a10*a35);
  a21=(a04*a36);
  a43=(a03*a51);
  a21=(a21+a43);
  a21=(a14*a21);
  a35=(a35-a21);
  a37=(a04*a37);
  a35=(a35+a37);
  a37=(a18*a60);
  a21=(a16*a54);
  a37=(a37+a21);
  a21=(a03*a37);
  a35=(a35+a21);
  a21=(a16*a51);
  a43=(a18*a36);
  a21=(a21-a43);
  a43=(a10*a60);
  a21=(a21-a43);
  a43=(a14*a54);
  a21=(a21+a43);
  a43=(a02*a21);
  a35=(a35+a43);
  a43=(a35*a08);
  a43=(a05*a43);
  a28=(a16*a36);
  a26=(a18*a51);
  a28=(a28+a26);
  a60=(a14*a60);
  a28=(a28+a60);
  a54=(a10*a54);
  a28=(a28+a54);
  a28=(a06*a28);
  a43=(a43-a28);
  a43=(a00*a43);
  a35=(a53*a35);
  a43=(a43-a35);
  a43=(a43*a01);
  a35=(a38*a43);
  a58=(a58+a35);
  if (res[0]!=0) res[0][8]=a58;
  a37=(a09*a37);
  a36=(a11*a36);
  a51=(a32*a51);
  a36=(a36+a51);
  a37=(a37-a36);
  a36=(a41*a43);
  a37=(a37+a36);
  if (res[0]!=0) res[0][9]=a37;
  a21=(a09*a21);
  a43=(a50*a43);
  a21=(a21+a43);
  if (res[0]!=0) res[0][10]=a21;
  if (res[0]!=0) res[0][11]=a07;
  a56=(a49+a56);
  a56=(a56-a48);
  a21=(a56*a25);
  a43=(a12*a31);
  a43=(a19*a43);
  a37=(a42*a13);
  a36=(a43-a37);
  a51=(a36*a22);
  a21=(a21+a51);
  if (res[0]!=0) res[0][12]=a21;
  a21=(a12*a17);
  a30=(a30+a21);
  a21=(a30*a25);
  a36=(a36*a15);
  a21=(a21-a36);
  if (res[0]!=0) res[0][13]=a21;
  a30=(a30*a22);
  a56=(a56*a15);
  a30=(a30+a56);
  a30=(-a30);
  if (res[0]!=0) res[0][14]=a30;
  a30=arg[6]? arg[6][1] : 0;
  a30=(-a30);
  if (res[0]!=0) res[0][15]=a30;
  a30=(a46-a57);
  a30=(a19*a30);
  a56=(a12*a30);
  a27=(a27+a20);
  a21=(a44+a27);
  a33=(a33*a21);
  a56=(a56+a33);
  a33=(a39-a34);
  a21=(a17*a33);
  a56=(a56+a21);
  a21=(a23-a29);
  a36=(a13*a21);
  a56=(a56+a36);
  a36=(a11*a56);
  a44=(a44-a27);
  a44=(a13*a44);
  a57=(a57+a46);
  a46=(a42*a57);
  a39=(a39+a34);
  a34=(a12*a39);
  a46=(a46-a34);
  a21=(a31*a21);
  a46=(a46+a21);
  a46=(a19*a46);
  a44=(a44+a46);
  a46=(a32*a44);
  a36=(a36-a46);
  a57=(a13*a57);
  a59=(a59-a20);
  a59=(a17*a59);
  a57=(a57+a59);
  a33=(a31*a33);
  a59=(a12*a29);
  a33=(a33-a59);
  a33=(a19*a33);
  a57=(a57+a33);
  a23=(-a23);
  a19=(a19*a23);
  a12=(a12*a19);
  a57=(a57+a12);
  a12=(a16*a57);
  a31=(a31*a30);
  a17=(a17*a29);
  a31=(a31-a17);
  a20=(a20-a24);
  a47=(a47*a20);
  a31=(a31+a47);
  a13=(a13*a39);
  a31=(a31-a13);
  a42=(a42*a19);
  a31=(a31+a42);
  a42=(a18*a31);
  a12=(a12-a42);
  a42=(a09*a12);
  a36=(a36+a42);
  a42=(a04*a56);
  a19=(a03*a44);
  a42=(a42-a19);
  a42=(a10*a42);
  a19=(a04*a44);
  a13=(a03*a56);
  a19=(a19+a13);
  a19=(a14*a19);
  a42=(a42-a19);
  a04=(a04*a12);
  a42=(a42+a04);
  a04=(a18*a57);
  a12=(a16*a31);
  a04=(a04+a12);
  a03=(a03*a04);
  a42=(a42+a03);
  a03=(a16*a56);
  a12=(a18*a44);
  a03=(a03-a12);
  a12=(a10*a57);
  a03=(a03-a12);
  a12=(a14*a31);
  a03=(a03+a12);
  a02=(a02*a03);
  a42=(a42+a02);
  a08=(a42*a08);
  a05=(a05*a08);
  a16=(a16*a44);
  a18=(a18*a56);
  a16=(a16+a18);
  a14=(a14*a57);
  a16=(a16+a14);
  a10=(a10*a31);
  a16=(a16+a10);
  a06=(a06*a16);
  a05=(a05-a06);
  a00=(a00*a05);
  a53=(a53*a42);
  a00=(a00-a53);
  a00=(a00*a01);
  a38=(a38*a00);
  a36=(a36+a38);
  if (res[0]!=0) res[0][16]=a36;
  a04=(a09*a04);
  a11=(a11*a44);
  a32=(a32*a56);
  a11=(a11+a32);
  a04=(a04-a11);
  a41=(a41*a00);
  a04=(a04+a41);
  if (res[0]!=0) res[0][17]=a04;
  a09=(a09*a03);
  a50=(a50*a00);
  a09=(a09+a50);
  if (res[0]!=0) res[0][18]=a09;
  if (res[0]!=0) res[0][19]=a07;
  a55=(a55-a49);
  a55=(a55+a45);
  a55=(a55-a48);
  a48=(a55*a22);
  a43=(a43+a37);
  a37=(a43*a25);
  a48=(a48-a37);
  if (res[0]!=0) res[0][20]=a48;
  a40=(a40-a52);
  a25=(a40*a25);
  a55=(a55*a15);
  a25=(a25-a55);
  if (res[0]!=0) res[0][21]=a25;
  a43=(a43*a15);
  a40=(a40*a22);
  a43=(a43-a40);
  if (res[0]!=0) res[0][22]=a43;
  a43=arg[6]? arg[6][2] : 0;
  a43=(-a43);
  if (res[0]!=0) res[0][23]=a43;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_velocity_exact_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_velocity_exact_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_velocity_exact_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_velocity_exact_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_velocity_exact_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_velocity_exact_H_casadi_n_in(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_int va_velocity_exact_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real va_velocity_exact_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_velocity_exact_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "position";
    case 2: return "v_n";
    case 3: return "q_b2n_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "lever_b";
    case 6: return "a_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_velocity_exact_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_velocity_exact_H_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    case 4: return casadi_s1;
    case 5: return casadi_s1;
    case 6: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_velocity_exact_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_velocity_exact_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_velocity_exact_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


