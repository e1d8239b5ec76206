/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) sd_step_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void sd_step_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int sd_step_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int sd_step_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* sd_step_casadi:(position[3],v_n[3],q_b2n_wxyz[4],dtheta_ib_b[3],dv_b[3],dtheta_before[3],dv_before[3],dt)->(out_position[3],out_v_n[3],out_q_b2n_wxyz[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[7]? arg[7][0] : 0;
  a02=1.;
  a03=arg[0]? arg[0][2] : 0;
  a04=5.0000000000000000e-01;
  a05=(a04*a01);
  a06=arg[1]? arg[1][2] : 0;
  a07=(a05*a06);
  a07=(a03+a07);
  a08=6378137.;
  a09=6.6943799901413173e-03;
  a10=arg[0]? arg[0][1] : 0;
  a11=arg[1]? arg[1][1] : 0;
  a12=6.3354393272928204e+06;
  a13=sin(a10);
  a14=(a13*a13);
  a15=(a09*a14);
  a15=(a02-a15);
  a16=sqrt(a15);
  a15=(a15*a16);
  a15=(a12/a15);
  a15=(a03+a15);
  a15=(a02/a15);
  a17=(a11*a15);
  a18=(a05*a17);
  a18=(a10+a18);
  a19=sin(a18);
  a20=(a19*a19);
  a09=(a09*a20);
  a09=(a02-a09);
  a21=sqrt(a09);
  a22=(a02/a21);
  a23=(a08*a22);
  a23=(a07+a23);
  a23=(a02/a23);
  a24=(a01*a23);
  a25=arg[1]? arg[1][0] : 0;
  a26=arg[4]? arg[4][1] : 0;
  a27=8.3333333333333329e-02;
  a28=arg[4]? arg[4][0] : 0;
  a29=(a27*a28);
  a30=arg[5]? arg[5][2] : 0;
  a31=(a29*a30);
  a31=(a26+a31);
  a32=arg[3]? arg[3][0] : 0;
  a33=(a27*a32);
  a34=arg[6]? arg[6][2] : 0;
  a35=(a33*a34);
  a31=(a31+a35);
  a35=(a04*a28);
  a36=arg[3]? arg[3][2] : 0;
  a37=(a35*a36);
  a31=(a31+a37);
  a37=arg[5]? arg[5][0] : 0;
  a37=(a27*a37);
  a38=arg[4]? arg[4][2] : 0;
  a39=(a37*a38);
  a31=(a31-a39);
  a39=(a04*a32);
  a40=(a39*a38);
  a31=(a31-a40);
  a40=arg[6]? arg[6][0] : 0;
  a40=(a27*a40);
  a41=(a40*a36);
  a31=(a31-a41);
  a41=2.;
  a42=arg[2]? arg[2][1] : 0;
  a43=arg[2]? arg[2][2] : 0;
  a44=(a42*a43);
  a44=(a41*a44);
  a45=arg[2]? arg[2][0] : 0;
  a46=(a41*a45);
  a47=arg[2]? arg[2][3] : 0;
  a48=(a46*a47);
  a44=(a44-a48);
  a44=(a31*a44);
  a49=(a04*a44);
  a49=(a25+a49);
  a50=(a37*a26);
  a50=(a38+a50);
  a39=(a39*a26);
  a50=(a50+a39);
  a39=arg[3]? arg[3][1] : 0;
  a40=(a40*a39);
  a50=(a50+a40);
  a40=arg[5]? arg[5][1] : 0;
  a29=(a29*a40);
  a50=(a50-a29);
  a29=arg[6]? arg[6][1] : 0;
  a51=(a33*a29);
  a50=(a50-a51);
  a35=(a35*a39);
  a50=(a50-a35);
  a35=(a46*a43);
  a51=(a41*a42);
  a52=(a51*a47);
  a52=(a35+a52);
  a52=(a50*a52);
  a53=(a04*a52);
  a49=(a49+a53);
  a53=(a27*a40);
  a54=(a53*a38);
  a28=(a28+a54);
  a38=(a39*a38);
  a38=(a04*a38);
  a28=(a28+a38);
  a29=(a36*a29);
  a29=(a27*a29);
  a28=(a28+a29);
  a29=(a27*a30);
  a38=(a29*a26);
  a28=(a28-a38);
  a26=(a36*a26);
  a26=(a04*a26);
  a28=(a28-a26);
  a34=(a39*a34);
  a27=(a27*a34);
  a28=(a28-a27);
  a27=(a42*a42);
  a34=(a45*a45);
  a26=(a47*a47);
  a38=(a34-a26);
  a54=(a27+a38);
  a55=(a43*a43);
  a54=(a54-a55);
  a54=(a28*a54);
  a56=(a04*a54);
  a49=(a49+a56);
  a56=(a43*a47);
  a56=(a41*a56);
  a46=(a46*a42);
  a57=(a56-a46);
  a57=(a50*a57);
  a58=(a04*a57);
  a58=(a11+a58);
  a51=(a51*a43);
  a48=(a48+a51);
  a48=(a28*a48);
  a51=(a04*a48);
  a58=(a58+a51);
  a51=(a55-a27);
  a51=(a51+a38);
  a51=(a31*a51);
  a38=(a04*a51);
  a58=(a58+a38);
  a38=1.4584230000000000e-04;
  a59=(a38*a13);
  a16=(a02/a16);
  a08=(a08*a16);
  a08=(a03+a08);
  a08=(a25/a08);
  a60=cos(a10);
  a13=(a13/a60);
  a13=(a08*a13);
  a59=(a59+a13);
  a13=(a59*a25);
  a17=(a17*a06);
  a13=(a13+a17);
  a13=(a05*a13);
  a13=(a58-a13);
  a59=(a59*a11);
  a60=(a38*a60);
  a08=(a08+a60);
  a60=(a08*a06);
  a59=(a59-a60);
  a59=(a05*a59);
  a59=(a49+a59);
  a23=(a59*a23);
  a18=cos(a18);
  a60=(a02/a18);
  a17=(a19*a60);
  a17=(a23*a17);
  a61=(a38*a19);
  a61=(a17+a61);
  a62=(a13*a61);
  a63=(a42*a47);
  a41=(a41*a63);
  a41=(a41-a35);
  a28=(a28*a41);
  a41=(a04*a28);
  a41=(a06+a41);
  a46=(a46+a56);
  a31=(a31*a46);
  a46=(a04*a31);
  a41=(a41+a46);
  a34=(a34-a27);
  a34=(a34+a26);
  a34=(a34-a55);
  a50=(a50*a34);
  a34=(a04*a50);
  a41=(a41+a34);
  a34=(a11*a11);
  a34=(a34*a15);
  a08=(a08*a25);
  a34=(a34+a08);
  a08=9.7803253359000006e+00;
  a15=1.8894147482439335e-02;
  a55=(a15*a14);
  a55=(a08+a55);
  a55=(a55*a16);
  a16=7.3745167729419953e-14;
  a26=(a03*a03);
  a26=(a16*a26);
  a26=(a02+a26);
  a27=1.5678559428873979e-07;
  a46=2.0136051943431768e+00;
  a56=1.3411242658989924e-02;
  a14=(a56*a14);
  a14=(a46-a14);
  a14=(a03*a14);
  a14=(a27*a14);
  a26=(a26-a14);
  a55=(a55*a26);
  a34=(a34-a55);
  a34=(a05*a34);
  a34=(a41+a34);
  a38=(a38*a18);
  a38=(a23+a38);
  a55=(a34*a38);
  a62=(a62-a55);
  a62=(a01*a62);
  a55=(a04*a62);
  a49=(a49+a55);
  a57=(a57+a48);
  a57=(a57+a51);
  a51=2.5000000000000000e-01;
  a51=(a51*a01);
  a48=7.2921149999999999e-05;
  a19=(a48*a19);
  a17=(a17+a19);
  a19=(a51*a17);
  a55=(a57*a19);
  a49=(a49+a55);
  a48=(a48*a18);
  a23=(a23+a48);
  a28=(a28+a31);
  a28=(a28+a50);
  a50=(a23*a28);
  a31=(a51*a50);
  a49=(a49-a31);
  a24=(a24*a49);
  a24=(a24*a60);
  a00=(a00+a24);
  if (res[0]!=0) res[0][0]=a00;
  a09=(a09*a21);
  a12=(a12/a09);
  a12=(a07+a12);
  a09=(a02/a12);
  a21=(a01*a09);
  a34=(a34*a09);
  a34=(a34*a13);
  a61=(a59*a61);
  a34=(a34+a61);
  a34=(a01*a34);
  a61=(a04*a34);
  a58=(a58-a61);
  a61=(a13*a09);
  a00=(a51*a61);
  a24=(a28*a00);
  a58=(a58-a24);
  a44=(a44+a52);
  a44=(a44+a54);
  a19=(a19*a44);
  a58=(a58-a19);
  a21=(a21*a58);
  a10=(a10+a21);
  if (res[0]!=0) res[0][1]=a10;
  a59=(a59*a38);
  a38=(a13*a61);
  a59=(a59+a38);
  a15=(a15*a20);
  a08=(a08+a15);
  a08=(a08*a22);
  a22=(a07*a07);
  a16=(a16*a22);
  a16=(a02+a16);
  a56=(a56*a20);
  a46=(a46-a56);
  a07=(a07*a46);
  a27=(a27*a07);
  a16=(a16-a27);
  a08=(a08*a16);
  a59=(a59-a08);
  a59=(a01*a59);
  a08=(a04*a59);
  a41=(a41+a08);
  a08=(a23*a44);
  a51=(a51*a08);
  a41=(a41+a51);
  a00=(a57*a00);
  a41=(a41+a00);
  a41=(a01*a41);
  a03=(a03+a41);
  if (res[0]!=0) res[0][2]=a03;
  a62=(a62+a44);
  a62=(a62+a25);
  a25=(a05*a17);
  a03=(a57*a25);
  a62=(a62+a03);
  a50=(a05*a50);
  a62=(a62-a50);
  if (res[1]!=0) res[1][0]=a62;
  a34=(a57-a34);
  a34=(a34+a11);
  a11=(a05*a61);
  a62=(a28*a11);
  a34=(a34-a62);
  a44=(a44*a25);
  a34=(a34-a44);
  if (res[1]!=0) res[1][1]=a34;
  a28=(a28+a59);
  a28=(a28+a06);
  a05=(a05*a08);
  a28=(a28+a05);
  a57=(a57*a11);
  a28=(a28+a57);
  if (res[1]!=0) res[1][2]=a28;
  a28=1.0000000000000001e-30;
  a57=(a01*a01);
  a11=(a23*a23);
  a11=(a57*a11);
  a11=(a28+a11);
  a05=(a17*a17);
  a05=(a57*a05);
  a11=(a11+a05);
  a05=(a13*a13);
  a57=(a57*a05);
  a12=(a12*a12);
  a57=(a57/a12);
  a11=(a11+a57);
  a11=sqrt(a11);
  a57=(a04*a11);
  a12=sin(a57);
  a11=(a02/a11);
  a05=(a12*a11);
  a05=(a05*a01);
  a08=(a37*a39);
  a08=(a36+a08);
  a40=(a33*a40);
  a08=(a08-a40);
  a40=(a08*a08);
  a28=(a28+a40);
  a33=(a33*a30);
  a33=(a39+a33);
  a37=(a37*a36);
  a33=(a33-a37);
  a37=(a33*a33);
  a28=(a28+a37);
  a53=(a53*a36);
  a32=(a32+a53);
  a29=(a29*a39);
  a32=(a32-a29);
  a29=(a32*a32);
  a28=(a28+a29);
  a28=sqrt(a28);
  a04=(a04*a28);
  a29=cos(a04);
  a39=(a29*a43);
  a04=sin(a04);
  a04=(a04/a28);
  a32=(a32*a04);
  a28=(a32*a47);
  a39=(a39+a28);
  a33=(a33*a04);
  a28=(a33*a45);
  a39=(a39+a28);
  a08=(a08*a04);
  a04=(a08*a42);
  a39=(a39-a04);
  a04=(a05*a39);
  a28=(a04*a23);
  a53=(a29*a47);
  a36=(a33*a42);
  a53=(a53+a36);
  a36=(a08*a45);
  a53=(a53+a36);
  a36=(a32*a43);
  a53=(a53-a36);
  a36=(a53*a05);
  a37=(a36*a17);
  a28=(a28+a37);
  a37=(a29*a45);
  a30=(a32*a42);
  a37=(a37-a30);
  a30=(a33*a43);
  a37=(a37-a30);
  a30=(a08*a47);
  a37=(a37-a30);
  a57=cos(a57);
  a30=(a37*a57);
  a28=(a28+a30);
  a29=(a29*a42);
  a32=(a32*a45);
  a29=(a29+a32);
  a08=(a08*a43);
  a29=(a29+a08);
  a33=(a33*a47);
  a29=(a29-a33);
  a33=(a61*a05);
  a47=(a29*a33);
  a28=(a28-a47);
  a47=(a28*a28);
  a08=(a53*a57);
  a43=(a23*a29);
  a43=(a43*a11);
  a43=(a43*a12);
  a43=(a43*a01);
  a08=(a08+a43);
  a61=(a04*a61);
  a08=(a08+a61);
  a61=(a17*a05);
  a43=(a61*a37);
  a08=(a08-a43);
  a43=(a08*a08);
  a47=(a47+a43);
  a04=(a04*a17);
  a17=(a57*a29);
  a04=(a04+a17);
  a36=(a36*a23);
  a04=(a04-a36);
  a33=(a37*a33);
  a04=(a04+a33);
  a33=(a04*a04);
  a47=(a47+a33);
  a57=(a57*a39);
  a53=(a53*a09);
  a53=(a53*a13);
  a53=(a53*a11);
  a53=(a53*a12);
  a53=(a53*a01);
  a57=(a57-a53);
  a61=(a61*a29);
  a57=(a57-a61);
  a23=(a23*a37);
  a23=(a23*a05);
  a57=(a57-a23);
  a23=(a57*a57);
  a47=(a47+a23);
  a47=sqrt(a47);
  a02=(a02/a47);
  a28=(a28*a02);
  if (res[2]!=0) res[2][0]=a28;
  a04=(a04*a02);
  if (res[2]!=0) res[2][1]=a04;
  a57=(a57*a02);
  if (res[2]!=0) res[2][2]=a57;
  a08=(a08*a02);
  if (res[2]!=0) res[2][3]=a08;
  return 0;
}

CASADI_SYMBOL_EXPORT int sd_step_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int sd_step_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void sd_step_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void sd_step_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void sd_step_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int sd_step_casadi_n_in(void) { return 8;}

CASADI_SYMBOL_EXPORT casadi_int sd_step_casadi_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real sd_step_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sd_step_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "position";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "dtheta_ib_b";
    case 4: return "dv_b";
    case 5: return "dtheta_before";
    case 6: return "dv_before";
    case 7: return "dt";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sd_step_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_position";
    case 1: return "out_v_n";
    case 2: return "out_q_b2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sd_step_casadi_sparsity_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const casadi_int* sd_step_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int sd_step_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int sd_step_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


