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
  casadi_real a84, a85, a86, a87, a88, a89, a90;
  a00=arg[2]? arg[2][0] : 0;
  a01=arg[0]? arg[0][6] : 0;
  a01=(a00-a01);
  a02=5.0000000000000000e-01;
  a03=1.0000000000000001e-30;
  a04=casadi_sq(a01);
  a05=(a03+a04);
  a06=arg[2]? arg[2][1] : 0;
  a07=arg[0]? arg[0][7] : 0;
  a07=(a06-a07);
  a08=casadi_sq(a07);
  a05=(a05+a08);
  a09=arg[2]? arg[2][2] : 0;
  a10=arg[0]? arg[0][8] : 0;
  a10=(a09-a10);
  a11=casadi_sq(a10);
  a05=(a05+a11);
  a12=sqrt(a05);
  a13=(a02*a12);
  a14=sin(a13);
  a15=casadi_sq(a14);
  a15=(a15/a05);
  a05=(a01*a15);
  a16=(2.*a10);
  a17=(a05*a16);
  a07=(2.*a07);
  a13=cos(a13);
  a14=(a14*a13);
  a14=(a14/a12);
  a12=(a07*a14);
  a18=(a17-a12);
  a19=arg[3]? arg[3][2] : 0;
  a20=arg[3]? arg[3][3] : 0;
  a21=(a19*a20);
  a21=(2.*a21);
  a22=arg[3]? arg[3][0] : 0;
  a23=(2.*a22);
  a24=arg[3]? arg[3][1] : 0;
  a25=(a23*a24);
  a26=(a21-a25);
  a27=(a18*a26);
  a05=(a05*a07);
  a16=(a16*a14);
  a28=(a05+a16);
  a29=casadi_sq(a19);
  a22=casadi_sq(a22);
  a30=casadi_sq(a24);
  a31=(a22-a30);
  a32=(a29+a31);
  a33=casadi_sq(a20);
  a32=(a32-a33);
  a34=(a28*a32);
  a27=(a27+a34);
  a13=casadi_sq(a13);
  a11=(a11*a15);
  a34=(a13-a11);
  a04=(a04*a15);
  a08=(a08*a15);
  a35=(a04-a08);
  a34=(a34+a35);
  a36=(a23*a20);
  a37=(a24*a19);
  a37=(2.*a37);
  a38=(a36+a37);
  a39=(a34*a38);
  a27=(a27+a39);
  a39=arg[0]? arg[0][3] : 0;
  a40=(2.*a39);
  a39=casadi_sq(a39);
  a41=(a03+a39);
  a42=arg[0]? arg[0][4] : 0;
  a43=casadi_sq(a42);
  a41=(a41+a43);
  a44=arg[0]? arg[0][5] : 0;
  a45=casadi_sq(a44);
  a41=(a41+a45);
  a46=sqrt(a41);
  a47=(a02*a46);
  a48=sin(a47);
  a49=casadi_sq(a48);
  a49=(a49/a41);
  a41=(a49*a44);
  a41=(a40*a41);
  a47=cos(a47);
  a48=(a48*a47);
  a48=(a48/a46);
  a46=(2.*a42);
  a46=(a48*a46);
  a50=(a41+a46);
  a51=arg[4]? arg[4][0] : 0;
  a52=(2.*a51);
  a53=arg[0]? arg[0][9] : 0;
  a54=casadi_sq(a53);
  a51=casadi_sq(a51);
  a51=(a54*a51);
  a55=(a03+a51);
  a56=arg[4]? arg[4][1] : 0;
  a57=casadi_sq(a56);
  a57=(a54*a57);
  a55=(a55+a57);
  a58=arg[4]? arg[4][2] : 0;
  a59=casadi_sq(a58);
  a59=(a54*a59);
  a55=(a55+a59);
  a60=sqrt(a55);
  a61=(a02*a60);
  a62=sin(a61);
  a63=casadi_sq(a62);
  a63=(a63/a55);
  a55=(a54*a63);
  a55=(a55*a58);
  a64=(a52*a55);
  a61=cos(a61);
  a62=(a62*a61);
  a62=(a62*a53);
  a62=(a62/a60);
  a60=(2.*a56);
  a53=(a62*a60);
  a65=(a64-a53);
  a66=(a50*a65);
  a67=(a49*a42);
  a67=(a67*a44);
  a67=(2.*a67);
  a68=(a40*a48);
  a69=(a67-a68);
  a55=(a55*a60);
  a60=(a52*a62);
  a70=(a55+a60);
  a71=(a69*a70);
  a66=(a66+a71);
  a43=(a43*a49);
  a45=(a45*a49);
  a71=(a43-a45);
  a39=(a39*a49);
  a47=casadi_sq(a47);
  a72=(a39-a47);
  a71=(a71+a72);
  a57=(a57*a63);
  a59=(a59*a63);
  a73=(a57-a59);
  a51=(a51*a63);
  a61=casadi_sq(a61);
  a74=(a51-a61);
  a73=(a73+a74);
  a75=(a71*a73);
  a66=(a66+a75);
  a75=arg[1]? arg[1][1] : 0;
  a76=arg[1]? arg[1][3] : 0;
  a77=(a75*a76);
  a77=(2.*a77);
  a78=arg[1]? arg[1][0] : 0;
  a79=(2.*a78);
  a80=arg[1]? arg[1][2] : 0;
  a81=(a79*a80);
  a82=(a77-a81);
  a83=(a66*a82);
  a83=(a02*a83);
  a40=(a40*a49);
  a40=(a40*a42);
  a48=(a48*a44);
  a48=(2.*a48);
  a44=(a40-a48);
  a42=(a65*a44);
  a72=(a45+a72);
  a72=(a72-a43);
  a49=(a70*a72);
  a42=(a42-a49);
  a68=(a68+a67);
  a67=(a73*a68);
  a42=(a42-a67);
  a67=(a79*a76);
  a49=(2.*a80);
  a84=(a49*a75);
  a85=(a67+a84);
  a86=(a42*a85);
  a86=(a02*a86);
  a83=(a83+a86);
  a86=casadi_sq(a75);
  a80=casadi_sq(a80);
  a87=(a86-a80);
  a78=casadi_sq(a78);
  a88=casadi_sq(a76);
  a89=(a78-a88);
  a90=(a87+a89);
  a47=(a47-a45);
  a47=(a47+a39);
  a47=(a47-a43);
  a65=(a65*a47);
  a40=(a40+a48);
  a70=(a70*a40);
  a65=(a65+a70);
  a41=(a41-a46);
  a73=(a73*a41);
  a65=(a65-a73);
  a73=(a90*a65);
  a73=(a02*a73);
  a83=(a83+a73);
  a73=(a27*a83);
  a01=(a01*a14);
  a01=(2.*a01);
  a10=(a10*a15);
  a10=(a10*a07);
  a07=(a01+a10);
  a15=(a07*a26);
  a05=(a05-a16);
  a16=(a05*a38);
  a15=(a15+a16);
  a35=(a11+a35);
  a35=(a35-a13);
  a16=(a35*a32);
  a15=(a15-a16);
  a79=(a79*a75);
  a49=(a49*a76);
  a76=(a79+a49);
  a75=(a66*a76);
  a75=(a02*a75);
  a89=(a89-a87);
  a87=(a42*a89);
  a87=(a02*a87);
  a75=(a75+a87);
  a84=(a84-a67);
  a67=(a65*a84);
  a67=(a02*a67);
  a75=(a75+a67);
  a67=(a15*a75);
  a73=(a73+a67);
  a12=(a12+a17);
  a17=(a12*a38);
  a10=(a10-a01);
  a01=(a10*a32);
  a17=(a17+a01);
  a04=(a04-a11);
  a04=(a04+a08);
  a04=(a04-a13);
  a13=(a04*a26);
  a17=(a17-a13);
  a78=(a78+a88);
  a78=(a78-a86);
  a78=(a78-a80);
  a66=(a66*a78);
  a66=(a02*a66);
  a49=(a49-a79);
  a42=(a42*a49);
  a42=(a02*a42);
  a66=(a66+a42);
  a81=(a81+a77);
  a65=(a65*a81);
  a65=(a02*a65);
  a66=(a66+a65);
  a65=(a17*a66);
  a73=(a73+a65);
  a65=casadi_sq(a00);
  a03=(a03+a65);
  a77=casadi_sq(a06);
  a03=(a03+a77);
  a42=casadi_sq(a09);
  a03=(a03+a42);
  a79=sqrt(a03);
  a80=(a02*a79);
  a86=sin(a80);
  a88=casadi_sq(a86);
  a88=(a88/a03);
  a03=(a88*a06);
  a03=(a03*a09);
  a03=(2.*a03);
  a00=(2.*a00);
  a80=cos(a80);
  a86=(a86*a80);
  a86=(a86/a79);
  a79=(a00*a86);
  a13=(a03-a79);
  a25=(a25+a21);
  a21=(a13*a25);
  a21=(a02*a21);
  a24=(a24*a20);
  a24=(2.*a24);
  a23=(a23*a19);
  a19=(a24-a23);
  a20=(a88*a09);
  a20=(a00*a20);
  a08=(2.*a06);
  a08=(a86*a08);
  a11=(a20+a08);
  a01=(a19*a11);
  a01=(a02*a01);
  a21=(a21+a01);
  a01=(a33-a29);
  a01=(a01+a31);
  a77=(a88*a77);
  a80=casadi_sq(a80);
  a31=(a77-a80);
  a65=(a88*a65);
  a42=(a88*a42);
  a67=(a65-a42);
  a31=(a31+a67);
  a87=(a01*a31);
  a87=(a02*a87);
  a21=(a21-a87);
  a87=(a49*a21);
  a73=(a73+a87);
  a67=(a80+a67);
  a67=(a67-a77);
  a87=(a19*a67);
  a87=(a02*a87);
  a20=(a20-a08);
  a08=(a01*a20);
  a08=(a02*a08);
  a87=(a87+a08);
  a00=(a00*a88);
  a00=(a00*a06);
  a86=(a86*a09);
  a86=(2.*a86);
  a09=(a00+a86);
  a06=(a25*a09);
  a06=(a02*a06);
  a87=(a87+a06);
  a06=(a85*a87);
  a73=(a73+a06);
  a00=(a00-a86);
  a86=(a19*a00);
  a86=(a02*a86);
  a79=(a79+a03);
  a03=(a01*a79);
  a03=(a02*a03);
  a86=(a86+a03);
  a65=(a65-a80);
  a65=(a65+a42);
  a65=(a65-a77);
  a77=(a65*a25);
  a77=(a02*a77);
  a86=(a86-a77);
  a77=(a89*a86);
  a73=(a73+a77);
  a52=(a52*a54);
  a52=(a52*a63);
  a52=(a52*a56);
  a62=(a62*a58);
  a62=(2.*a62);
  a58=(a52+a62);
  a56=(a47*a58);
  a74=(a59+a74);
  a74=(a74-a57);
  a63=(a40*a74);
  a56=(a56-a63);
  a55=(a55-a60);
  a60=(a41*a55);
  a56=(a56+a60);
  a60=(a90*a56);
  a63=(a50*a58);
  a54=(a69*a74);
  a63=(a63-a54);
  a54=(a71*a55);
  a63=(a63-a54);
  a54=(a63*a82);
  a60=(a60+a54);
  a58=(a44*a58);
  a74=(a72*a74);
  a58=(a58+a74);
  a55=(a68*a55);
  a58=(a58+a55);
  a55=(a58*a85);
  a60=(a60+a55);
  a55=(a18*a01);
  a55=(a02*a55);
  a74=(a28*a25);
  a74=(a02*a74);
  a55=(a55+a74);
  a74=(a34*a19);
  a74=(a02*a74);
  a55=(a55+a74);
  a74=(a60*a55);
  a73=(a73-a74);
  a74=(a81*a56);
  a54=(a49*a58);
  a74=(a74+a54);
  a54=(a63*a78);
  a74=(a74+a54);
  a54=(a12*a19);
  a54=(a02*a54);
  a77=(a10*a25);
  a77=(a02*a77);
  a54=(a54+a77);
  a77=(a04*a01);
  a77=(a02*a77);
  a54=(a54-a77);
  a77=(a74*a54);
  a73=(a73-a77);
  a56=(a84*a56);
  a63=(a63*a76);
  a56=(a56+a63);
  a58=(a58*a89);
  a56=(a56+a58);
  a01=(a07*a01);
  a01=(a02*a01);
  a19=(a05*a19);
  a19=(a02*a19);
  a01=(a01+a19);
  a25=(a35*a25);
  a25=(a02*a25);
  a01=(a01-a25);
  a25=(a56*a01);
  a73=(a73-a25);
  a25=(a26*a79);
  a19=(a38*a00);
  a25=(a25+a19);
  a19=(a32*a65);
  a25=(a25-a19);
  a19=(a02*a76);
  a58=(a25*a19);
  a73=(a73-a58);
  a58=(a26*a20);
  a63=(a38*a67);
  a58=(a58+a63);
  a63=(a32*a09);
  a58=(a58+a63);
  a63=(a02*a82);
  a77=(a58*a63);
  a73=(a73-a77);
  a32=(a13*a32);
  a38=(a11*a38);
  a32=(a32+a38);
  a26=(a31*a26);
  a32=(a32-a26);
  a26=(a02*a78);
  a38=(a32*a26);
  a73=(a73-a38);
  if (res[0]!=0) res[0][0]=a73;
  a52=(a52-a62);
  a40=(a40*a52);
  a61=(a61-a59);
  a61=(a61+a51);
  a61=(a61-a57);
  a47=(a47*a61);
  a40=(a40+a47);
  a64=(a64+a53);
  a41=(a41*a64);
  a40=(a40+a41);
  a41=(a90*a40);
  a50=(a50*a61);
  a69=(a69*a52);
  a50=(a50+a69);
  a71=(a71*a64);
  a50=(a50-a71);
  a82=(a50*a82);
  a41=(a41+a82);
  a44=(a44*a61);
  a72=(a72*a52);
  a44=(a44-a72);
  a68=(a68*a64);
  a44=(a44+a68);
  a68=(a44*a85);
  a41=(a41+a68);
  a55=(a55*a41);
  a68=(a81*a40);
  a64=(a49*a44);
  a68=(a68+a64);
  a78=(a50*a78);
  a68=(a68+a78);
  a54=(a54*a68);
  a55=(a55+a54);
  a40=(a84*a40);
  a50=(a50*a76);
  a40=(a40+a50);
  a44=(a44*a89);
  a40=(a40+a44);
  a01=(a01*a40);
  a55=(a55+a01);
  a23=(a23+a24);
  a79=(a23*a79);
  a22=(a22-a29);
  a22=(a22+a30);
  a22=(a22-a33);
  a00=(a22*a00);
  a79=(a79+a00);
  a37=(a37-a36);
  a65=(a37*a65);
  a79=(a79-a65);
  a19=(a79*a19);
  a55=(a55+a19);
  a20=(a23*a20);
  a67=(a22*a67);
  a20=(a20+a67);
  a09=(a37*a09);
  a20=(a20+a09);
  a63=(a20*a63);
  a55=(a55+a63);
  a13=(a13*a37);
  a31=(a23*a31);
  a13=(a13-a31);
  a11=(a22*a11);
  a13=(a13+a11);
  a26=(a13*a26);
  a55=(a55+a26);
  a87=(a90*a87);
  a55=(a55-a87);
  a18=(a18*a23);
  a28=(a28*a37);
  a18=(a18+a28);
  a34=(a34*a22);
  a18=(a18+a34);
  a83=(a83*a18);
  a55=(a55-a83);
  a86=(a84*a86);
  a55=(a55-a86);
  a07=(a07*a23);
  a05=(a05*a22);
  a07=(a07+a05);
  a35=(a35*a37);
  a07=(a07-a35);
  a75=(a75*a07);
  a55=(a55-a75);
  a21=(a81*a21);
  a55=(a55-a21);
  a12=(a12*a22);
  a10=(a10*a37);
  a12=(a12+a10);
  a04=(a04*a23);
  a12=(a12-a04);
  a66=(a66*a12);
  a55=(a55-a66);
  if (res[0]!=0) res[0][1]=a55;
  a90=(a90*a58);
  a90=(a02*a90);
  a84=(a84*a25);
  a84=(a02*a84);
  a90=(a90+a84);
  a81=(a81*a32);
  a81=(a02*a81);
  a90=(a90+a81);
  a60=(a60*a18);
  a60=(a02*a60);
  a90=(a90+a60);
  a74=(a74*a12);
  a74=(a02*a74);
  a90=(a90+a74);
  a56=(a56*a07);
  a56=(a02*a56);
  a90=(a90+a56);
  a27=(a27*a41);
  a27=(a02*a27);
  a90=(a90-a27);
  a15=(a15*a40);
  a15=(a02*a15);
  a90=(a90-a15);
  a17=(a17*a68);
  a17=(a02*a17);
  a90=(a90-a17);
  a49=(a49*a13);
  a49=(a02*a49);
  a90=(a90-a49);
  a79=(a79*a89);
  a79=(a02*a79);
  a90=(a90-a79);
  a20=(a20*a85);
  a02=(a02*a20);
  a90=(a90-a02);
  if (res[0]!=0) res[0][2]=a90;
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


