/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_dcm_exact_h_casadi__ ## ID
#endif

#include <math.h>
#include "../src/vd_math.h"
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

/* vd_dcm_exact_h_casadi:(x[10],q_b2n_wxyz[4],mu[3],q_m2n_wxyz[4],omega_nm_n[3])->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92;
  a00=5.0000000000000000e-01;
  a01=arg[3]? arg[3][1] : 0;
  a02=(2.*a01);
  a03=arg[3]? arg[3][3] : 0;
  a02=(a02*a03);
  a04=arg[3]? arg[3][0] : 0;
  a05=(2.*a04);
  a06=arg[3]? arg[3][2] : 0;
  a07=(a05*a06);
  a08=(a02-a07);
  a09=1.0000000000000001e-30;
  a10=arg[2]? arg[2][0] : 0;
  a11=casadi_sq(a10);
  a11=(a09+a11);
  a12=arg[2]? arg[2][1] : 0;
  a13=casadi_sq(a12);
  a11=(a11+a13);
  a13=arg[2]? arg[2][2] : 0;
  a14=casadi_sq(a13);
  a11=(a11+a14);
  a11=sqrt(a11);
  a14=(a00*a11);
  a15=sin(a14);
  a15=(a15/a11);
  a11=(a15*a10);
  a16=casadi_sq(a11);
  a17=(a15*a12);
  a18=casadi_sq(a17);
  a19=(a16-a18);
  a14=cos(a14);
  a20=casadi_sq(a14);
  a15=(a15*a13);
  a21=casadi_sq(a15);
  a22=(a20-a21);
  a23=(a19+a22);
  a24=(a08*a23);
  a24=(a00*a24);
  a25=(a05*a01);
  a26=(2.*a06);
  a27=(a26*a03);
  a28=(a25+a27);
  a14=(2.*a14);
  a29=(a14*a15);
  a30=(2.*a11);
  a31=(a30*a17);
  a32=(a29+a31);
  a33=(a28*a32);
  a33=(a00*a33);
  a24=(a24+a33);
  a33=casadi_sq(a03);
  a06=casadi_sq(a06);
  a34=(a33-a06);
  a04=casadi_sq(a04);
  a35=casadi_sq(a01);
  a36=(a04-a35);
  a37=(a34+a36);
  a30=(a30*a15);
  a38=(a14*a17);
  a39=(a30-a38);
  a40=(a37*a39);
  a40=(a00*a40);
  a24=(a24+a40);
  a40=arg[1]? arg[1][0] : 0;
  a41=(2.*a40);
  a42=arg[1]? arg[1][3] : 0;
  a43=(a41*a42);
  a44=arg[1]? arg[1][1] : 0;
  a45=(2.*a44);
  a46=arg[1]? arg[1][2] : 0;
  a47=(a45*a46);
  a48=(a43+a47);
  a49=(a24*a48);
  a31=(a31-a29);
  a29=(a08*a31);
  a29=(a00*a29);
  a22=(a22-a19);
  a19=(a28*a22);
  a19=(a00*a19);
  a29=(a29+a19);
  a14=(a14*a11);
  a17=(2.*a17);
  a17=(a17*a15);
  a15=(a14+a17);
  a11=(a37*a15);
  a11=(a00*a11);
  a29=(a29+a11);
  a11=casadi_sq(a46);
  a40=casadi_sq(a40);
  a19=casadi_sq(a42);
  a50=(a40-a19);
  a51=(a11+a50);
  a52=casadi_sq(a44);
  a51=(a51-a52);
  a53=(a29*a51);
  a49=(a49+a53);
  a53=arg[0]? arg[0][9] : 0;
  a54=casadi_sq(a53);
  a55=arg[4]? arg[4][0] : 0;
  a56=casadi_sq(a55);
  a56=(a54*a56);
  a56=(a09+a56);
  a57=arg[4]? arg[4][1] : 0;
  a58=casadi_sq(a57);
  a58=(a54*a58);
  a56=(a56+a58);
  a58=arg[4]? arg[4][2] : 0;
  a59=casadi_sq(a58);
  a54=(a54*a59);
  a56=(a56+a54);
  a56=sqrt(a56);
  a54=(a00*a56);
  a59=sin(a54);
  a53=(a53*a59);
  a53=(a53/a56);
  a55=(a53*a55);
  a56=(2.*a55);
  a58=(a53*a58);
  a59=(a56*a58);
  a54=cos(a54);
  a60=(2.*a54);
  a53=(a53*a57);
  a57=(a60*a53);
  a61=(a59-a57);
  a62=arg[0]? arg[0][3] : 0;
  a63=casadi_sq(a62);
  a63=(a09+a63);
  a64=arg[0]? arg[0][4] : 0;
  a65=casadi_sq(a64);
  a63=(a63+a65);
  a65=arg[0]? arg[0][5] : 0;
  a66=casadi_sq(a65);
  a63=(a63+a66);
  a63=sqrt(a63);
  a66=(a00*a63);
  a67=sin(a66);
  a67=(a67/a63);
  a62=(a67*a62);
  a63=casadi_sq(a62);
  a64=(a67*a64);
  a68=casadi_sq(a64);
  a69=(a63-a68);
  a66=cos(a66);
  a70=casadi_sq(a66);
  a67=(a67*a65);
  a65=casadi_sq(a67);
  a71=(a70-a65);
  a69=(a69+a71);
  a72=(a61*a69);
  a73=(a60*a55);
  a74=(2.*a58);
  a74=(a74*a53);
  a75=(a73+a74);
  a66=(2.*a66);
  a76=(a66*a67);
  a77=(2.*a62);
  a78=(a77*a64);
  a79=(a76+a78);
  a80=(a75*a79);
  a72=(a72+a80);
  a80=casadi_sq(a58);
  a81=casadi_sq(a53);
  a82=(a80-a81);
  a54=casadi_sq(a54);
  a55=casadi_sq(a55);
  a83=(a54-a55);
  a84=(a82+a83);
  a77=(a77*a67);
  a85=(a66*a64);
  a86=(a77-a85);
  a87=(a84*a86);
  a72=(a72+a87);
  a87=(a52-a11);
  a87=(a87+a50);
  a50=(a72*a87);
  a78=(a78-a76);
  a76=(a61*a78);
  a71=(a68+a71);
  a71=(a71-a63);
  a88=(a75*a71);
  a76=(a76+a88);
  a66=(a66*a62);
  a64=(2.*a64);
  a64=(a64*a67);
  a67=(a66+a64);
  a62=(a84*a67);
  a76=(a76+a62);
  a62=(a76*a48);
  a50=(a50+a62);
  a85=(a85+a77);
  a61=(a61*a85);
  a64=(a64-a66);
  a75=(a75*a64);
  a61=(a61+a75);
  a70=(a70-a68);
  a70=(a70+a65);
  a70=(a70-a63);
  a84=(a84*a70);
  a61=(a61+a84);
  a45=(a45*a42);
  a84=(a41*a46);
  a63=(a45-a84);
  a65=(a61*a63);
  a50=(a50+a65);
  a50=(a00*a50);
  a05=(a05*a03);
  a26=(a26*a01);
  a01=(a05+a26);
  a03=arg[0]? arg[0][6] : 0;
  a10=(a10-a03);
  a03=casadi_sq(a10);
  a09=(a09+a03);
  a03=arg[0]? arg[0][7] : 0;
  a12=(a12-a03);
  a03=casadi_sq(a12);
  a09=(a09+a03);
  a03=arg[0]? arg[0][8] : 0;
  a13=(a13-a03);
  a03=casadi_sq(a13);
  a09=(a09+a03);
  a09=sqrt(a09);
  a03=(a00*a09);
  a65=sin(a03);
  a65=(a65/a09);
  a10=(a10*a65);
  a09=casadi_sq(a10);
  a12=(a12*a65);
  a68=casadi_sq(a12);
  a75=(a09-a68);
  a03=cos(a03);
  a66=casadi_sq(a03);
  a13=(a13*a65);
  a65=casadi_sq(a13);
  a77=(a66-a65);
  a75=(a75+a77);
  a62=(a01*a75);
  a36=(a36-a34);
  a03=(2.*a03);
  a34=(a03*a13);
  a88=(2.*a10);
  a89=(a88*a12);
  a90=(a34+a89);
  a91=(a36*a90);
  a62=(a62+a91);
  a27=(a27-a25);
  a88=(a88*a13);
  a25=(a03*a12);
  a91=(a88-a25);
  a92=(a27*a91);
  a62=(a62+a92);
  a92=(a50*a62);
  a49=(a49+a92);
  a89=(a89-a34);
  a34=(a01*a89);
  a77=(a68+a77);
  a77=(a77-a09);
  a92=(a36*a77);
  a34=(a34+a92);
  a03=(a03*a10);
  a12=(2.*a12);
  a12=(a12*a13);
  a13=(a03+a12);
  a10=(a27*a13);
  a34=(a34+a10);
  a47=(a47-a43);
  a43=(a72*a47);
  a10=(a76*a51);
  a43=(a43+a10);
  a41=(a41*a44);
  a46=(2.*a46);
  a46=(a46*a42);
  a42=(a41+a46);
  a44=(a61*a42);
  a43=(a43+a44);
  a43=(a00*a43);
  a44=(a34*a43);
  a49=(a49+a44);
  a25=(a25+a88);
  a88=(a01*a25);
  a12=(a12-a03);
  a03=(a36*a12);
  a88=(a88+a03);
  a66=(a66-a68);
  a66=(a66+a65);
  a66=(a66-a09);
  a09=(a27*a66);
  a88=(a88+a09);
  a84=(a84+a45);
  a72=(a72*a84);
  a46=(a46-a41);
  a76=(a76*a46);
  a72=(a72+a76);
  a40=(a40-a11);
  a40=(a40+a19);
  a40=(a40-a52);
  a61=(a61*a40);
  a72=(a72+a61);
  a72=(a00*a72);
  a61=(a88*a72);
  a49=(a49+a61);
  a38=(a38+a30);
  a30=(a08*a38);
  a30=(a00*a30);
  a17=(a17-a14);
  a14=(a28*a17);
  a14=(a00*a14);
  a30=(a30+a14);
  a16=(a16+a18);
  a20=(a20-a16);
  a20=(a20+a21);
  a21=(a37*a20);
  a21=(a00*a21);
  a30=(a30+a21);
  a21=(a30*a46);
  a49=(a49+a21);
  a21=(a01*a23);
  a16=(a36*a32);
  a21=(a21+a16);
  a16=(a27*a39);
  a21=(a21+a16);
  a16=(a21*a63);
  a16=(a00*a16);
  a49=(a49-a16);
  a16=(a01*a31);
  a18=(a36*a22);
  a16=(a16+a18);
  a18=(a27*a15);
  a16=(a16+a18);
  a18=(a16*a42);
  a18=(a00*a18);
  a49=(a49-a18);
  a01=(a01*a38);
  a36=(a36*a17);
  a01=(a01+a36);
  a27=(a27*a20);
  a01=(a01+a27);
  a27=(a01*a40);
  a27=(a00*a27);
  a49=(a49-a27);
  a27=(a08*a75);
  a36=(a28*a90);
  a27=(a27+a36);
  a36=(a37*a91);
  a27=(a27+a36);
  a60=(a60*a58);
  a56=(a56*a53);
  a53=(a60+a56);
  a58=(a53*a69);
  a83=(a83-a82);
  a82=(a83*a79);
  a58=(a58+a82);
  a74=(a74-a73);
  a73=(a74*a86);
  a58=(a58+a73);
  a73=(a58*a87);
  a82=(a53*a78);
  a36=(a83*a71);
  a82=(a82+a36);
  a36=(a74*a67);
  a82=(a82+a36);
  a36=(a82*a48);
  a73=(a73+a36);
  a53=(a53*a85);
  a83=(a83*a64);
  a53=(a53+a83);
  a74=(a74*a70);
  a53=(a53+a74);
  a74=(a53*a63);
  a73=(a73+a74);
  a74=(a27*a73);
  a74=(a00*a74);
  a49=(a49-a74);
  a74=(a08*a89);
  a83=(a28*a77);
  a74=(a74+a83);
  a83=(a37*a13);
  a74=(a74+a83);
  a83=(a58*a47);
  a36=(a82*a51);
  a83=(a83+a36);
  a36=(a53*a42);
  a83=(a83+a36);
  a36=(a74*a83);
  a36=(a00*a36);
  a49=(a49-a36);
  a08=(a08*a25);
  a28=(a28*a12);
  a08=(a08+a28);
  a37=(a37*a66);
  a08=(a08+a37);
  a58=(a58*a84);
  a82=(a82*a46);
  a58=(a58+a82);
  a53=(a53*a40);
  a58=(a58+a53);
  a53=(a08*a58);
  a53=(a00*a53);
  a49=(a49-a53);
  if (res[0]!=0) res[0][0]=a49;
  a06=(a06+a33);
  a04=(a04-a06);
  a04=(a04+a35);
  a23=(a04*a23);
  a26=(a26-a05);
  a32=(a26*a32);
  a23=(a23+a32);
  a07=(a07+a02);
  a39=(a07*a39);
  a23=(a23+a39);
  a39=(a23*a63);
  a39=(a00*a39);
  a31=(a04*a31);
  a22=(a26*a22);
  a31=(a31+a22);
  a15=(a07*a15);
  a31=(a31+a15);
  a15=(a31*a42);
  a15=(a00*a15);
  a39=(a39+a15);
  a38=(a04*a38);
  a17=(a26*a17);
  a38=(a38+a17);
  a20=(a07*a20);
  a38=(a38+a20);
  a20=(a38*a40);
  a20=(a00*a20);
  a39=(a39+a20);
  a80=(a80+a81);
  a54=(a54-a80);
  a54=(a54+a55);
  a69=(a54*a69);
  a56=(a56-a60);
  a79=(a56*a79);
  a69=(a69+a79);
  a57=(a57+a59);
  a86=(a57*a86);
  a69=(a69+a86);
  a86=(a69*a87);
  a78=(a54*a78);
  a71=(a56*a71);
  a78=(a78+a71);
  a67=(a57*a67);
  a78=(a78+a67);
  a67=(a78*a48);
  a86=(a86+a67);
  a54=(a54*a85);
  a56=(a56*a64);
  a54=(a54+a56);
  a57=(a57*a70);
  a54=(a54+a57);
  a63=(a54*a63);
  a86=(a86+a63);
  a27=(a27*a86);
  a27=(a00*a27);
  a39=(a39+a27);
  a27=(a69*a47);
  a63=(a78*a51);
  a27=(a27+a63);
  a42=(a54*a42);
  a27=(a27+a42);
  a74=(a74*a27);
  a74=(a00*a74);
  a39=(a39+a74);
  a69=(a69*a84);
  a78=(a78*a46);
  a69=(a69+a78);
  a54=(a54*a40);
  a69=(a69+a54);
  a08=(a08*a69);
  a08=(a00*a08);
  a39=(a39+a08);
  a24=(a24*a87);
  a39=(a39-a24);
  a29=(a29*a47);
  a39=(a39-a29);
  a75=(a04*a75);
  a90=(a26*a90);
  a75=(a75+a90);
  a91=(a07*a91);
  a75=(a75+a91);
  a50=(a50*a75);
  a39=(a39-a50);
  a89=(a04*a89);
  a77=(a26*a77);
  a89=(a89+a77);
  a13=(a07*a13);
  a89=(a89+a13);
  a43=(a43*a89);
  a39=(a39-a43);
  a04=(a04*a25);
  a26=(a26*a12);
  a04=(a04+a26);
  a07=(a07*a66);
  a04=(a04+a07);
  a72=(a72*a04);
  a39=(a39-a72);
  a30=(a30*a84);
  a39=(a39-a30);
  if (res[0]!=0) res[0][1]=a39;
  a75=(a75*a73);
  a75=(a00*a75);
  a89=(a89*a83);
  a89=(a00*a89);
  a75=(a75+a89);
  a04=(a04*a58);
  a04=(a00*a04);
  a75=(a75+a04);
  a21=(a21*a87);
  a21=(a00*a21);
  a75=(a75+a21);
  a16=(a16*a47);
  a16=(a00*a16);
  a75=(a75+a16);
  a01=(a01*a84);
  a01=(a00*a01);
  a75=(a75+a01);
  a34=(a34*a27);
  a34=(a00*a34);
  a75=(a75-a34);
  a88=(a88*a69);
  a88=(a00*a88);
  a75=(a75-a88);
  a23=(a23*a48);
  a23=(a00*a23);
  a75=(a75-a23);
  a31=(a31*a51);
  a31=(a00*a31);
  a75=(a75-a31);
  a38=(a38*a46);
  a38=(a00*a38);
  a75=(a75-a38);
  a62=(a62*a86);
  a00=(a00*a62);
  a75=(a75-a00);
  if (res[0]!=0) res[0][2]=a75;
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
    case 3: return "q_m2n_wxyz";
    case 4: return "omega_nm_n";
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


