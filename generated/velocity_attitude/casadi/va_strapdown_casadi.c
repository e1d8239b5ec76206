/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_strapdown_casadi__ ## ID
#endif

#include <math.h>
#include "../src/va_math.h"
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
CASADI_SYMBOL_EXPORT void va_strapdown_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_strapdown_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_strapdown_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* va_strapdown_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],gyro_bias[3],accel_bias[3],dt,dtheta_ib_b[3],dv_b[3],dtheta_before[3],dv_before[3])->(out_lat_lon_height[3],out_v_n[3],out_q_b2n_wxyz[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=1.;
  a03=6.3354393272928204e+06;
  a04=6.6943799901413173e-03;
  a05=arg[1]? arg[1][0] : 0;
  a06=arg[0]? arg[0][2] : 0;
  a07=sin(a00);
  a08=(a07*a07);
  a09=(a04*a08);
  a09=(a02-a09);
  a10=sqrt(a09);
  a09=(a09*a10);
  a09=(a03/a09);
  a09=(a06+a09);
  a09=(a05/a09);
  a11=5.0000000000000000e-01;
  a12=(a11*a01);
  a13=(a09*a12);
  a13=(a00+a13);
  a14=sin(a13);
  a15=(a14*a14);
  a04=(a04*a15);
  a04=(a02-a04);
  a16=sqrt(a04);
  a04=(a04*a16);
  a03=(a03/a04);
  a04=arg[1]? arg[1][2] : 0;
  a17=(a12*a04);
  a17=(a06-a17);
  a03=(a03+a17);
  a03=(a02/a03);
  a18=(a01*a03);
  a19=arg[2]? arg[2][1] : 0;
  a20=(a19*a19);
  a21=arg[2]? arg[2][2] : 0;
  a22=(a21*a21);
  a23=(a20-a22);
  a24=arg[2]? arg[2][0] : 0;
  a25=(a24*a24);
  a26=arg[2]? arg[2][3] : 0;
  a27=(a26*a26);
  a28=(a25-a27);
  a23=(a23+a28);
  a29=arg[7]? arg[7][0] : 0;
  a30=arg[7]? arg[7][2] : 0;
  a31=arg[4]? arg[4][2] : 0;
  a31=(a31*a01);
  a32=(a30-a31);
  a33=arg[3]? arg[3][1] : 0;
  a33=(a33*a01);
  a34=arg[6]? arg[6][1] : 0;
  a35=(a33-a34);
  a36=(a32*a35);
  a37=(a11*a36);
  a37=(a29-a37);
  a38=arg[3]? arg[3][2] : 0;
  a38=(a38*a01);
  a39=arg[6]? arg[6][2] : 0;
  a40=(a38-a39);
  a41=arg[7]? arg[7][1] : 0;
  a42=arg[4]? arg[4][1] : 0;
  a42=(a42*a01);
  a43=(a41-a42);
  a44=(a40*a43);
  a45=(a11*a44);
  a37=(a37+a45);
  a45=1.6666666666666666e-01;
  a46=arg[3]? arg[3][0] : 0;
  a46=(a46*a01);
  a47=arg[6]? arg[6][0] : 0;
  a48=(a46-a47);
  a49=(a32*a48);
  a50=arg[4]? arg[4][0] : 0;
  a50=(a50*a01);
  a51=(a29-a50);
  a52=(a40*a51);
  a53=(a49-a52);
  a54=(a45*a53);
  a55=(a40*a54);
  a37=(a37+a55);
  a55=arg[8]? arg[8][1] : 0;
  a55=(a33-a55);
  a56=8.3333333333333329e-02;
  a32=(a56*a32);
  a57=(a55*a32);
  a37=(a37-a57);
  a57=(a35*a51);
  a58=(a43*a48);
  a59=(a57-a58);
  a60=(a45*a59);
  a61=(a35*a60);
  a37=(a37-a61);
  a61=arg[8]? arg[8][2] : 0;
  a61=(a38-a61);
  a43=(a56*a43);
  a62=(a61*a43);
  a37=(a37+a62);
  a62=arg[9]? arg[9][2] : 0;
  a63=(a31-a62);
  a64=(a56*a35);
  a65=(a63*a64);
  a37=(a37-a65);
  a37=(a37-a50);
  a65=arg[9]? arg[9][1] : 0;
  a66=(a42-a65);
  a67=(a56*a40);
  a68=(a66*a67);
  a37=(a37+a68);
  a68=(a23*a37);
  a69=2.;
  a70=(a69*a19);
  a71=(a70*a21);
  a72=(a69*a24);
  a73=(a72*a26);
  a74=(a71-a73);
  a52=(a11*a52);
  a52=(a41-a52);
  a49=(a11*a49);
  a52=(a52+a49);
  a44=(a44-a36);
  a45=(a45*a44);
  a40=(a40*a45);
  a52=(a52-a40);
  a40=arg[9]? arg[9][0] : 0;
  a50=(a50-a40);
  a36=(a67*a50);
  a52=(a52-a36);
  a36=arg[8]? arg[8][0] : 0;
  a36=(a46-a36);
  a32=(a32*a36);
  a52=(a52+a32);
  a60=(a48*a60);
  a52=(a52+a60);
  a51=(a56*a51);
  a60=(a61*a51);
  a52=(a52-a60);
  a52=(a52-a42);
  a42=(a56*a48);
  a63=(a63*a42);
  a52=(a52+a63);
  a63=(a74*a52);
  a68=(a68+a63);
  a63=(a72*a21);
  a70=(a70*a26);
  a60=(a63+a70);
  a58=(a11*a58);
  a58=(a30-a58);
  a57=(a11*a57);
  a58=(a58+a57);
  a66=(a66*a42);
  a58=(a58-a66);
  a51=(a55*a51);
  a58=(a58+a51);
  a35=(a35*a45);
  a58=(a58+a35);
  a43=(a43*a36);
  a58=(a58-a43);
  a48=(a48*a54);
  a58=(a58-a48);
  a58=(a58-a31);
  a50=(a64*a50);
  a58=(a58+a50);
  a50=(a60*a58);
  a68=(a68+a50);
  a50=(a11*a68);
  a31=(a50+a05);
  a48=7.2921149999999999e-05;
  a54=(a48*a14);
  a43=(-a54);
  a43=(a69*a43);
  a13=cos(a13);
  a35=(a02/a13);
  a14=(a14*a35);
  a73=(a73+a71);
  a71=(a73*a37);
  a28=(a22+a28);
  a28=(a28-a20);
  a45=(a28*a52);
  a71=(a71+a45);
  a45=(a69*a21);
  a45=(a45*a26);
  a72=(a72*a19);
  a51=(a45-a72);
  a66=(a51*a58);
  a71=(a71+a66);
  a66=(a11*a71);
  a57=arg[1]? arg[1][1] : 0;
  a32=(a66+a57);
  a49=1.4584230000000000e-04;
  a75=cos(a00);
  a76=(a49*a75);
  a77=6378137.;
  a10=(a02/a10);
  a78=(a77*a10);
  a78=(a06+a78);
  a78=(a57/a78);
  a76=(a76+a78);
  a79=(a04*a76);
  a80=(a48*a07);
  a80=(-a80);
  a69=(a69*a80);
  a07=(a07/a75);
  a78=(a78*a07);
  a69=(a69-a78);
  a78=(a05*a69);
  a79=(a79-a78);
  a79=(a12*a79);
  a79=(a32+a79);
  a16=(a02/a16);
  a77=(a77*a16);
  a77=(a77+a17);
  a77=(a02/a77);
  a78=(a79*a77);
  a14=(a14*a78);
  a43=(a43-a14);
  a07=(a43*a79);
  a69=(a57*a69);
  a75=(a04*a09);
  a69=(a69+a75);
  a69=(a12*a69);
  a69=(a31+a69);
  a03=(a69*a03);
  a70=(a70-a63);
  a37=(a70*a37);
  a72=(a72+a45);
  a52=(a72*a52);
  a37=(a37+a52);
  a25=(a25-a22);
  a25=(a25+a27);
  a25=(a25-a20);
  a58=(a25*a58);
  a37=(a37+a58);
  a58=(a11*a37);
  a20=(a58+a04);
  a27=7.3745167729419953e-14;
  a22=(a06*a06);
  a22=(a27*a22);
  a22=(a02+a22);
  a52=1.5678559428873979e-07;
  a45=2.0136051943431768e+00;
  a63=1.3411242658989924e-02;
  a75=(a63*a08);
  a75=(a45-a75);
  a75=(a06*a75);
  a75=(a52*a75);
  a22=(a22-a75);
  a75=9.7803253359000006e+00;
  a80=1.8894147482439335e-02;
  a08=(a80*a08);
  a08=(a75+a08);
  a08=(a08*a10);
  a22=(a22*a08);
  a09=(a05*a09);
  a22=(a22-a09);
  a76=(a57*a76);
  a22=(a22-a76);
  a12=(a12*a22);
  a12=(a20+a12);
  a22=(a03*a12);
  a07=(a07+a22);
  a07=(a01*a07);
  a22=(a11*a07);
  a31=(a31+a22);
  a22=2.5000000000000000e-01;
  a14=(a14+a54);
  a14=(a01*a14);
  a54=(a22*a14);
  a76=(a54*a71);
  a31=(a31-a76);
  a44=(a44-a40);
  a44=(a44+a29);
  a23=(a44*a23);
  a53=(a53-a65);
  a53=(a53+a41);
  a74=(a53*a74);
  a23=(a23+a74);
  a59=(a59-a62);
  a59=(a59+a30);
  a60=(a59*a60);
  a23=(a23+a60);
  a23=(a56*a23);
  a31=(a31-a23);
  a23=(a22*a37);
  a60=(a01*a03);
  a30=(a23*a60);
  a31=(a31+a30);
  a18=(a18*a31);
  a00=(a00+a18);
  if (res[0]!=0) res[0][0]=a00;
  a00=arg[0]? arg[0][1] : 0;
  a77=(a01*a77);
  a49=(a49*a13);
  a49=(a49+a78);
  a12=(a49*a12);
  a43=(a43*a69);
  a12=(a12-a43);
  a12=(a01*a12);
  a43=(a11*a12);
  a32=(a32+a43);
  a48=(a48*a13);
  a78=(a78+a48);
  a78=(a01*a78);
  a23=(a23*a78);
  a32=(a32+a23);
  a73=(a44*a73);
  a28=(a53*a28);
  a73=(a73+a28);
  a51=(a59*a51);
  a73=(a73+a51);
  a73=(a56*a73);
  a32=(a32-a73);
  a54=(a54*a68);
  a32=(a32+a54);
  a77=(a77*a32);
  a77=(a77*a35);
  a00=(a00+a77);
  if (res[0]!=0) res[0][1]=a00;
  a44=(a44*a70);
  a53=(a53*a72);
  a44=(a44+a53);
  a59=(a59*a25);
  a44=(a44+a59);
  a56=(a56*a44);
  a44=(a71*a78);
  a44=(a22*a44);
  a56=(a56+a44);
  a56=(a56-a20);
  a20=(a17*a17);
  a27=(a27*a20);
  a27=(a02+a27);
  a63=(a63*a15);
  a45=(a45-a63);
  a45=(a45*a17);
  a52=(a52*a45);
  a27=(a27-a52);
  a80=(a80*a15);
  a75=(a75+a80);
  a75=(a75*a16);
  a27=(a27*a75);
  a03=(a03*a69);
  a27=(a27-a03);
  a49=(a49*a79);
  a27=(a27-a49);
  a27=(a01*a27);
  a49=(a11*a27);
  a56=(a56-a49);
  a49=(a68*a60);
  a22=(a22*a49);
  a56=(a56+a22);
  a01=(a01*a56);
  a06=(a06+a01);
  if (res[0]!=0) res[0][2]=a06;
  a07=(a07+a05);
  a05=(a66*a14);
  a07=(a07-a05);
  a07=(a07+a68);
  a68=(a58*a60);
  a07=(a07+a68);
  if (res[1]!=0) res[1][0]=a07;
  a12=(a12+a57);
  a58=(a58*a78);
  a12=(a12+a58);
  a12=(a12+a71);
  a71=(a50*a14);
  a12=(a12+a71);
  if (res[1]!=0) res[1][1]=a12;
  a27=(a27+a04);
  a50=(a50*a60);
  a27=(a27-a50);
  a27=(a27+a37);
  a66=(a66*a78);
  a27=(a27-a66);
  if (res[1]!=0) res[1][2]=a27;
  a27=1.0000000000000001e-30;
  a66=(a67*a55);
  a47=(a47+a66);
  a66=(a61*a64);
  a47=(a47-a66);
  a47=(a47-a46);
  a46=(a47*a47);
  a46=(a27+a46);
  a67=(a67*a36);
  a34=(a34-a67);
  a61=(a61*a42);
  a34=(a34+a61);
  a34=(a34-a33);
  a33=(a34*a34);
  a46=(a46+a33);
  a55=(a55*a42);
  a39=(a39-a55);
  a64=(a64*a36);
  a39=(a39+a64);
  a39=(a39-a38);
  a38=(a39*a39);
  a46=(a46+a38);
  a46=sqrt(a46);
  a38=(a11*a46);
  a64=cos(a38);
  a36=(a24*a64);
  a38=sin(a38);
  a38=(a38/a46);
  a47=(a38*a47);
  a46=(a19*a47);
  a36=(a36-a46);
  a34=(a38*a34);
  a46=(a21*a34);
  a36=(a36-a46);
  a38=(a38*a39);
  a39=(a26*a38);
  a36=(a36-a39);
  a39=(a14*a14);
  a27=(a27+a39);
  a39=(a60*a60);
  a27=(a27+a39);
  a39=(a78*a78);
  a27=(a27+a39);
  a27=sqrt(a27);
  a11=(a11*a27);
  a39=cos(a11);
  a46=(a36*a39);
  a55=(a24*a47);
  a42=(a19*a64);
  a55=(a55+a42);
  a42=(a21*a38);
  a55=(a55+a42);
  a42=(a26*a34);
  a55=(a55-a42);
  a11=sin(a11);
  a11=(a11/a27);
  a78=(a11*a78);
  a27=(a55*a78);
  a46=(a46+a27);
  a27=(a24*a34);
  a42=(a21*a64);
  a27=(a27+a42);
  a42=(a26*a47);
  a27=(a27+a42);
  a42=(a19*a38);
  a27=(a27-a42);
  a60=(a11*a60);
  a42=(a27*a60);
  a46=(a46-a42);
  a24=(a24*a38);
  a19=(a19*a34);
  a24=(a24+a19);
  a26=(a26*a64);
  a24=(a24+a26);
  a21=(a21*a47);
  a24=(a24-a21);
  a11=(a11*a14);
  a14=(a24*a11);
  a46=(a46-a14);
  a14=(a46*a46);
  a21=(a55*a39);
  a47=(a24*a60);
  a21=(a21+a47);
  a47=(a36*a78);
  a21=(a21-a47);
  a47=(a27*a11);
  a21=(a21-a47);
  a47=(a21*a21);
  a14=(a14+a47);
  a47=(a55*a11);
  a26=(a27*a39);
  a47=(a47+a26);
  a26=(a36*a60);
  a47=(a47+a26);
  a26=(a24*a78);
  a47=(a47+a26);
  a26=(a47*a47);
  a14=(a14+a26);
  a24=(a24*a39);
  a27=(a27*a78);
  a24=(a24-a27);
  a36=(a36*a11);
  a24=(a24+a36);
  a55=(a55*a60);
  a24=(a24-a55);
  a55=(a24*a24);
  a14=(a14+a55);
  a14=sqrt(a14);
  a02=(a02/a14);
  a46=(a46*a02);
  if (res[2]!=0) res[2][0]=a46;
  a21=(a21*a02);
  if (res[2]!=0) res[2][1]=a21;
  a47=(a47*a02);
  if (res[2]!=0) res[2][2]=a47;
  a24=(a24*a02);
  if (res[2]!=0) res[2][3]=a24;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_strapdown_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_strapdown_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_strapdown_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_strapdown_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_strapdown_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_strapdown_casadi_n_in(void) { return 10;}

CASADI_SYMBOL_EXPORT casadi_int va_strapdown_casadi_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real va_strapdown_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_strapdown_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "gyro_bias";
    case 4: return "accel_bias";
    case 5: return "dt";
    case 6: return "dtheta_ib_b";
    case 7: return "dv_b";
    case 8: return "dtheta_before";
    case 9: return "dv_before";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_strapdown_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_lat_lon_height";
    case 1: return "out_v_n";
    case 2: return "out_q_b2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_strapdown_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s0;
    case 5: return casadi_s2;
    case 6: return casadi_s0;
    case 7: return casadi_s0;
    case 8: return casadi_s0;
    case 9: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_strapdown_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_strapdown_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_strapdown_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


