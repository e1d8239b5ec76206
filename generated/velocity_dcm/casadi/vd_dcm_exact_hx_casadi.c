/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_dcm_exact_h_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vd_dcm_exact_h_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {10, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {3, 1, 1};

/* vd_dcm_exact_h_casadi:(x[10],q_b2n_wxyz[4],mu[3],q_r2n_wxyz[4],omega_nr_n[3])->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72;
  a00=5.0000000000000000e-01;
  a01=arg[0]? arg[0][8] : 0;
  a02=arg[2]? arg[2][2] : 0;
  a01=(a01-a02);
  a03=1.0000000000000001e-30;
  a04=arg[0]? arg[0][6] : 0;
  a05=arg[2]? arg[2][0] : 0;
  a04=(a04-a05);
  a06=(a04*a04);
  a07=(a03+a06);
  a08=arg[0]? arg[0][7] : 0;
  a09=arg[2]? arg[2][1] : 0;
  a08=(a08-a09);
  a10=(a08*a08);
  a07=(a07+a10);
  a11=(a01*a01);
  a07=(a07+a11);
  a12=sqrt(a07);
  a13=(a00*a12);
  a14=sin(a13);
  a15=(a14*a14);
  a16=1.;
  a16=(a16/a07);
  a07=(a15*a16);
  a17=(a01*a07);
  a18=2.;
  a04=(a18*a04);
  a19=(a17*a04);
  a13=cos(a13);
  a14=(a14*a13);
  a14=(a14/a12);
  a12=(a18*a08);
  a20=(a14*a12);
  a21=(a19+a20);
  a22=arg[0]? arg[0][5] : 0;
  a23=(a18*a22);
  a24=arg[0]? arg[0][3] : 0;
  a25=(a24*a24);
  a26=(a03+a25);
  a27=arg[0]? arg[0][4] : 0;
  a28=(a27*a27);
  a26=(a26+a28);
  a29=(a22*a22);
  a26=(a26+a29);
  a30=sqrt(a26);
  a31=(a00*a30);
  a32=sin(a31);
  a33=(a32*a32);
  a33=(a33/a26);
  a26=(a33*a24);
  a34=(a23*a26);
  a35=(a18*a27);
  a31=cos(a31);
  a32=(a32*a31);
  a32=(a32/a30);
  a30=(a35*a32);
  a36=(a34+a30);
  a37=arg[1]? arg[1][1] : 0;
  a38=arg[1]? arg[1][3] : 0;
  a39=(a37*a38);
  a39=(a18*a39);
  a40=arg[1]? arg[1][0] : 0;
  a41=(a18*a40);
  a42=arg[1]? arg[1][2] : 0;
  a43=(a41*a42);
  a44=(a39-a43);
  a45=(a36*a44);
  a26=(a26*a35);
  a35=(a23*a32);
  a46=(a26-a35);
  a47=(a41*a38);
  a48=(a18*a42);
  a49=(a48*a37);
  a49=(a47+a49);
  a50=(a46*a49);
  a45=(a45+a50);
  a50=(a37*a37);
  a51=(a42*a42);
  a52=(a50-a51);
  a40=(a40*a40);
  a53=(a38*a38);
  a54=(a40-a53);
  a52=(a52+a54);
  a31=(a31*a31);
  a29=(a29*a33);
  a55=(a31-a29);
  a25=(a25*a33);
  a28=(a28*a33);
  a56=(a25-a28);
  a55=(a55+a56);
  a57=(a52*a55);
  a45=(a45+a57);
  a57=(a21*a45);
  a58=(a01*a08);
  a58=(a58*a16);
  a58=(a58*a15);
  a58=(a18*a58);
  a15=(a14*a04);
  a58=(a58-a15);
  a41=(a41*a37);
  a48=(a48*a38);
  a48=(a41+a48);
  a16=(a36*a48);
  a59=(a51-a50);
  a59=(a59+a54);
  a54=(a46*a59);
  a16=(a16+a54);
  a37=(a37*a42);
  a37=(a18*a37);
  a37=(a37-a47);
  a47=(a55*a37);
  a16=(a16+a47);
  a47=(a58*a16);
  a57=(a57+a47);
  a10=(a10*a07);
  a13=(a13*a13);
  a47=(a10-a13);
  a06=(a06*a07);
  a11=(a11*a07);
  a54=(a06-a11);
  a47=(a47+a54);
  a40=(a40+a53);
  a40=(a40-a50);
  a40=(a40-a51);
  a36=(a36*a40);
  a42=(a42*a38);
  a42=(a18*a42);
  a42=(a42-a41);
  a46=(a46*a42);
  a36=(a36+a46);
  a43=(a43+a39);
  a55=(a55*a43);
  a36=(a36+a55);
  a55=(a47*a36);
  a57=(a57-a55);
  a55=arg[4]? arg[4][0] : 0;
  a39=(a18*a55);
  a46=arg[0]? arg[0][9] : 0;
  a41=(a46*a46);
  a38=(a55*a55);
  a38=(a41*a38);
  a51=(a03+a38);
  a50=arg[4]? arg[4][1] : 0;
  a53=(a50*a50);
  a53=(a41*a53);
  a51=(a51+a53);
  a60=arg[4]? arg[4][2] : 0;
  a61=(a60*a60);
  a61=(a41*a61);
  a51=(a51+a61);
  a62=sqrt(a51);
  a63=(a00*a62);
  a64=sin(a63);
  a65=(a64*a64);
  a65=(a65/a51);
  a41=(a41*a65);
  a51=(a41*a60);
  a66=(a39*a51);
  a50=(a18*a50);
  a63=cos(a63);
  a64=(a64*a63);
  a64=(a64*a46);
  a64=(a64/a62);
  a62=(a50*a64);
  a46=(a66-a62);
  a67=(a57*a46);
  a51=(a51*a50);
  a39=(a39*a64);
  a68=(a51+a39);
  a26=(a26+a35);
  a35=(a52*a26);
  a69=(a33*a27);
  a69=(a69*a22);
  a69=(a18*a69);
  a32=(a32*a24);
  a32=(a18*a32);
  a69=(a69-a32);
  a24=(a69*a44);
  a35=(a35+a24);
  a56=(a29+a56);
  a56=(a56-a31);
  a24=(a56*a49);
  a35=(a35-a24);
  a24=(a21*a35);
  a22=(a37*a26);
  a70=(a69*a48);
  a22=(a22+a70);
  a70=(a56*a59);
  a22=(a22-a70);
  a70=(a58*a22);
  a24=(a24+a70);
  a26=(a43*a26);
  a69=(a69*a40);
  a26=(a26+a69);
  a56=(a56*a42);
  a26=(a26-a56);
  a56=(a47*a26);
  a24=(a24-a56);
  a56=(a68*a24);
  a67=(a67+a56);
  a53=(a53*a65);
  a61=(a61*a65);
  a56=(a53-a61);
  a38=(a38*a65);
  a63=(a63*a63);
  a65=(a38-a63);
  a56=(a56+a65);
  a34=(a34-a30);
  a30=(a52*a34);
  a23=(a23*a33);
  a23=(a23*a27);
  a32=(a32+a23);
  a23=(a32*a49);
  a30=(a30+a23);
  a25=(a25-a29);
  a25=(a25+a28);
  a25=(a25-a31);
  a31=(a25*a44);
  a30=(a30-a31);
  a21=(a21*a30);
  a31=(a37*a34);
  a28=(a32*a59);
  a31=(a31+a28);
  a28=(a25*a48);
  a31=(a31-a28);
  a58=(a58*a31);
  a21=(a21+a58);
  a34=(a43*a34);
  a32=(a32*a42);
  a34=(a34+a32);
  a25=(a25*a40);
  a34=(a34-a25);
  a47=(a47*a34);
  a21=(a21-a47);
  a47=(a56*a21);
  a67=(a67-a47);
  a47=arg[3]? arg[3][2] : 0;
  a25=arg[3]? arg[3][3] : 0;
  a32=(a47*a25);
  a32=(a18*a32);
  a58=arg[3]? arg[3][0] : 0;
  a28=(a18*a58);
  a29=arg[3]? arg[3][1] : 0;
  a23=(a28*a29);
  a32=(a32-a23);
  a27=(a67*a32);
  a27=(a00*a27);
  a54=(a13+a54);
  a54=(a54-a10);
  a33=(a35*a54);
  a08=(a08*a07);
  a08=(a08*a04);
  a01=(a01*a14);
  a01=(a18*a01);
  a14=(a08+a01);
  a04=(a22*a14);
  a33=(a33+a04);
  a19=(a19-a20);
  a20=(a26*a19);
  a33=(a33+a20);
  a20=(a68*a33);
  a04=(a30*a54);
  a07=(a31*a14);
  a04=(a04+a07);
  a07=(a34*a19);
  a04=(a04+a07);
  a07=(a56*a04);
  a20=(a20-a07);
  a54=(a45*a54);
  a14=(a16*a14);
  a54=(a54+a14);
  a19=(a36*a19);
  a54=(a54+a19);
  a19=(a54*a46);
  a20=(a20+a19);
  a19=(a28*a25);
  a14=(a29*a47);
  a14=(a18*a14);
  a07=(a19+a14);
  a69=(a20*a07);
  a69=(a00*a69);
  a27=(a27+a69);
  a08=(a08-a01);
  a35=(a35*a08);
  a06=(a06-a13);
  a06=(a06+a11);
  a06=(a06-a10);
  a22=(a22*a06);
  a35=(a35-a22);
  a17=(a17*a12);
  a15=(a15+a17);
  a26=(a26*a15);
  a35=(a35+a26);
  a68=(a68*a35);
  a30=(a30*a08);
  a31=(a31*a06);
  a30=(a30-a31);
  a34=(a34*a15);
  a30=(a30+a34);
  a56=(a56*a30);
  a68=(a68-a56);
  a45=(a45*a08);
  a16=(a16*a06);
  a45=(a45-a16);
  a36=(a36*a15);
  a45=(a45+a36);
  a46=(a45*a46);
  a68=(a68+a46);
  a46=(a47*a47);
  a58=(a58*a58);
  a36=(a29*a29);
  a15=(a58-a36);
  a16=(a46+a15);
  a06=(a25*a25);
  a16=(a16-a06);
  a08=(a68*a16);
  a08=(a00*a08);
  a27=(a27+a08);
  a08=(a18*a25);
  a56=(a08*a47);
  a23=(a23+a56);
  a56=(a05*a05);
  a03=(a03+a56);
  a34=(a09*a09);
  a03=(a03+a34);
  a31=(a02*a02);
  a03=(a03+a31);
  a26=sqrt(a03);
  a17=(a00*a26);
  a12=sin(a17);
  a22=(a12*a12);
  a22=(a22/a03);
  a03=(a22*a09);
  a03=(a03*a02);
  a03=(a18*a03);
  a17=cos(a17);
  a12=(a12*a17);
  a12=(a12/a26);
  a26=(a12*a05);
  a26=(a18*a26);
  a03=(a03-a26);
  a10=(a42*a03);
  a05=(a22*a05);
  a11=(a18*a09);
  a13=(a05*a11);
  a02=(a18*a02);
  a01=(a02*a12);
  a69=(a13+a01);
  a70=(a49*a69);
  a10=(a10+a70);
  a31=(a22*a31);
  a17=(a17*a17);
  a70=(a31-a17);
  a56=(a22*a56);
  a34=(a22*a34);
  a71=(a56-a34);
  a70=(a70+a71);
  a72=(a59*a70);
  a10=(a10-a72);
  a72=(a23*a10);
  a72=(a00*a72);
  a27=(a27+a72);
  a25=(a29*a25);
  a25=(a18*a25);
  a28=(a28*a47);
  a25=(a25-a28);
  a05=(a02*a05);
  a12=(a12*a11);
  a11=(a05+a12);
  a47=(a42*a11);
  a72=(a17-a31);
  a72=(a72+a71);
  a71=(a49*a72);
  a47=(a47+a71);
  a13=(a13-a01);
  a01=(a59*a13);
  a47=(a47+a01);
  a01=(a25*a47);
  a01=(a00*a01);
  a27=(a27+a01);
  a01=(a06-a46);
  a01=(a01+a15);
  a22=(a22*a02);
  a22=(a22*a09);
  a26=(a26+a22);
  a59=(a26*a59);
  a05=(a05-a12);
  a49=(a05*a49);
  a59=(a59+a49);
  a56=(a56-a17);
  a56=(a56+a34);
  a56=(a56-a31);
  a42=(a56*a42);
  a59=(a59-a42);
  a42=(a01*a59);
  a42=(a00*a42);
  a27=(a27+a42);
  a41=(a41*a50);
  a41=(a41*a55);
  a64=(a64*a60);
  a18=(a18*a64);
  a64=(a41+a18);
  a60=(a64*a45);
  a51=(a51-a39);
  a39=(a51*a30);
  a60=(a60+a39);
  a65=(a61+a65);
  a65=(a65-a53);
  a39=(a65*a35);
  a60=(a60-a39);
  a39=(a00*a23);
  a55=(a60*a39);
  a27=(a27-a55);
  a55=(a64*a54);
  a50=(a51*a04);
  a55=(a55+a50);
  a50=(a65*a33);
  a55=(a55-a50);
  a50=(a00*a25);
  a42=(a55*a50);
  a27=(a27-a42);
  a64=(a57*a64);
  a65=(a24*a65);
  a64=(a64-a65);
  a51=(a21*a51);
  a64=(a64+a51);
  a51=(a00*a01);
  a65=(a64*a51);
  a27=(a27-a65);
  a65=(a26*a48);
  a42=(a44*a05);
  a65=(a65+a42);
  a42=(a40*a56);
  a65=(a65-a42);
  a32=(a00*a32);
  a42=(a65*a32);
  a27=(a27-a42);
  a42=(a44*a72);
  a31=(a48*a13);
  a42=(a42+a31);
  a31=(a40*a11);
  a42=(a42+a31);
  a07=(a00*a07);
  a31=(a42*a07);
  a27=(a27-a31);
  a44=(a44*a69);
  a48=(a48*a70);
  a44=(a44-a48);
  a40=(a40*a03);
  a44=(a44+a40);
  a16=(a00*a16);
  a40=(a44*a16);
  a27=(a27-a40);
  if (res[0]!=0) res[0][0]=a27;
  a08=(a08*a29);
  a28=(a28+a08);
  a65=(a28*a65);
  a65=(a00*a65);
  a14=(a14-a19);
  a44=(a14*a44);
  a44=(a00*a44);
  a65=(a65+a44);
  a58=(a58-a46);
  a58=(a58+a36);
  a58=(a58-a06);
  a42=(a58*a42);
  a42=(a00*a42);
  a65=(a65+a42);
  a63=(a63-a61);
  a63=(a63+a38);
  a63=(a63-a53);
  a45=(a45*a63);
  a66=(a66+a62);
  a30=(a30*a66);
  a45=(a45+a30);
  a41=(a41-a18);
  a35=(a35*a41);
  a45=(a45+a35);
  a23=(a45*a23);
  a23=(a00*a23);
  a65=(a65+a23);
  a54=(a54*a63);
  a04=(a04*a66);
  a54=(a54+a04);
  a33=(a33*a41);
  a54=(a54+a33);
  a25=(a54*a25);
  a25=(a00*a25);
  a65=(a65+a25);
  a57=(a57*a63);
  a24=(a24*a41);
  a57=(a57+a24);
  a21=(a21*a66);
  a57=(a57+a21);
  a01=(a57*a01);
  a01=(a00*a01);
  a65=(a65+a01);
  a28=(a00*a28);
  a67=(a67*a28);
  a65=(a65-a67);
  a69=(a52*a69);
  a70=(a37*a70);
  a69=(a69-a70);
  a03=(a43*a03);
  a69=(a69+a03);
  a39=(a39*a69);
  a65=(a65-a39);
  a72=(a52*a72);
  a13=(a37*a13);
  a72=(a72+a13);
  a11=(a43*a11);
  a72=(a72+a11);
  a50=(a50*a72);
  a65=(a65-a50);
  a58=(a00*a58);
  a20=(a20*a58);
  a65=(a65-a20);
  a52=(a52*a05);
  a37=(a37*a26);
  a52=(a52+a37);
  a43=(a43*a56);
  a52=(a52-a43);
  a51=(a51*a52);
  a65=(a65-a51);
  a00=(a00*a14);
  a68=(a68*a00);
  a65=(a65-a68);
  if (res[0]!=0) res[0][1]=a65;
  a60=(a60*a00);
  a55=(a55*a58);
  a60=(a60+a55);
  a64=(a64*a28);
  a60=(a60+a64);
  a69=(a69*a16);
  a60=(a60+a69);
  a72=(a72*a07);
  a60=(a60+a72);
  a52=(a52*a32);
  a60=(a60+a52);
  a45=(a45*a16);
  a60=(a60-a45);
  a54=(a54*a07);
  a60=(a60-a54);
  a28=(a28*a59);
  a60=(a60-a28);
  a00=(a00*a10);
  a60=(a60-a00);
  a57=(a57*a32);
  a60=(a60-a57);
  a58=(a58*a47);
  a60=(a60-a58);
  if (res[0]!=0) res[0][2]=a60;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_h_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_h_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_h_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_exact_h_casadi_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_exact_h_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vd_dcm_exact_h_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_exact_h_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "q_b2n_wxyz";
    case 2: return "mu";
    case 3: return "q_r2n_wxyz";
    case 4: return "omega_nr_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_exact_h_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_exact_h_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s1;
    case 4: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_exact_h_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


