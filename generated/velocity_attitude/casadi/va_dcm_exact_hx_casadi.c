/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_dcm_exact_h_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void va_dcm_exact_h_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_dcm_exact_h_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_dcm_exact_h_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {16, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {4, 1, 1};
static const casadi_int casadi_s3[3] = {1, 1, 1};

/* va_dcm_exact_h_casadi:(x[16],position[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],q_m2n_wxyz[4],lag)->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92, a93;
  a00=arg[7]? arg[7][0] : 0;
  a01=arg[0]? arg[0][15] : 0;
  a01=(a00-a01);
  a02=arg[0]? arg[0][7] : 0;
  a03=arg[5]? arg[5][1] : 0;
  a02=(a02+a03);
  a04=5.0000000000000000e-01;
  a05=1.0000000000000001e-30;
  a06=arg[0]? arg[0][2] : 0;
  a07=casadi_sq(a06);
  a07=(a05+a07);
  a08=arg[0]? arg[0][1] : 0;
  a09=casadi_sq(a08);
  a07=(a07+a09);
  a09=arg[0]? arg[0][0] : 0;
  a10=casadi_sq(a09);
  a07=(a07+a10);
  a07=sqrt(a07);
  a10=(a04*a07);
  a11=cos(a10);
  a12=arg[3]? arg[3][2] : 0;
  a13=(a11*a12);
  a10=sin(a10);
  a10=(a10/a07);
  a07=(a10*a06);
  a14=arg[3]? arg[3][1] : 0;
  a15=(a07*a14);
  a13=(a13+a15);
  a15=(a10*a08);
  a16=arg[3]? arg[3][0] : 0;
  a17=(a15*a16);
  a13=(a13+a17);
  a17=arg[3]? arg[3][3] : 0;
  a18=(a10*a17);
  a19=(a18*a09);
  a13=(a13-a19);
  a19=(a11*a14);
  a20=(a18*a08);
  a19=(a19+a20);
  a20=(a10*a09);
  a21=(a20*a16);
  a19=(a19+a21);
  a10=(a10*a12);
  a21=(a10*a06);
  a19=(a19-a21);
  a21=(a13*a19);
  a21=(2.*a21);
  a22=(a11*a17);
  a07=(a07*a16);
  a22=(a22+a07);
  a09=(a10*a09);
  a22=(a22+a09);
  a15=(a15*a14);
  a22=(a22-a15);
  a11=(a11*a16);
  a18=(a18*a06);
  a11=(a11-a18);
  a20=(a20*a14);
  a11=(a11-a20);
  a10=(a10*a08);
  a11=(a11-a10);
  a10=(2.*a11);
  a08=(a22*a10);
  a21=(a21-a08);
  a21=(a02*a21);
  a20=arg[2]? arg[2][1] : 0;
  a18=arg[1]? arg[1][2] : 0;
  a06=6378137.;
  a15=1.;
  a09=6.6943799901413173e-03;
  a07=arg[1]? arg[1][0] : 0;
  a23=sin(a07);
  a24=casadi_sq(a23);
  a09=(a09*a24);
  a15=(a15-a09);
  a09=sqrt(a15);
  a06=(a06/a09);
  a06=(a18+a06);
  a20=(a20/a06);
  a06=7.2921149999999999e-05;
  a07=cos(a07);
  a24=(a06*a07);
  a24=(a20+a24);
  a25=arg[0]? arg[0][6] : 0;
  a26=arg[5]? arg[5][0] : 0;
  a25=(a25+a26);
  a27=casadi_sq(a13);
  a28=casadi_sq(a19);
  a29=(a27-a28);
  a30=casadi_sq(a22);
  a31=casadi_sq(a11);
  a32=(a30-a31);
  a29=(a29+a32);
  a29=(a25*a29);
  a29=(a24+a29);
  a21=(a21-a29);
  a29=arg[0]? arg[0][8] : 0;
  a33=arg[5]? arg[5][2] : 0;
  a29=(a29+a33);
  a34=(2.*a19);
  a35=(a22*a34);
  a36=(a13*a10);
  a37=(a35+a36);
  a37=(a29*a37);
  a21=(a21+a37);
  a21=(a01*a21);
  a37=arg[0]? arg[0][12] : 0;
  a38=casadi_sq(a37);
  a05=(a05+a38);
  a38=arg[0]? arg[0][13] : 0;
  a39=casadi_sq(a38);
  a05=(a05+a39);
  a39=arg[0]? arg[0][14] : 0;
  a40=casadi_sq(a39);
  a05=(a05+a40);
  a05=sqrt(a05);
  a40=(a04*a05);
  a41=cos(a40);
  a42=arg[4]? arg[4][0] : 0;
  a43=(a41*a42);
  a40=sin(a40);
  a40=(a40/a05);
  a37=(a40*a37);
  a05=arg[4]? arg[4][1] : 0;
  a44=(a37*a05);
  a43=(a43-a44);
  a44=arg[4]? arg[4][3] : 0;
  a45=(a40*a44);
  a46=(a45*a39);
  a43=(a43-a46);
  a46=(a40*a38);
  a47=arg[4]? arg[4][2] : 0;
  a48=(a46*a47);
  a43=(a43-a48);
  a48=(a13*a43);
  a40=(a40*a39);
  a39=(a40*a47);
  a49=(a41*a05);
  a39=(a39-a49);
  a49=(a37*a42);
  a39=(a39-a49);
  a45=(a45*a38);
  a39=(a39-a45);
  a45=(a22*a39);
  a48=(a48+a45);
  a45=(a37*a44);
  a38=(a41*a47);
  a45=(a45-a38);
  a38=(a40*a05);
  a45=(a45-a38);
  a38=(a46*a42);
  a45=(a45-a38);
  a38=(a11*a45);
  a48=(a48+a38);
  a46=(a46*a05);
  a41=(a41*a44);
  a46=(a46-a41);
  a37=(a37*a47);
  a46=(a46-a37);
  a40=(a40*a42);
  a46=(a46-a40);
  a40=(a19*a46);
  a48=(a48-a40);
  a40=(2.*a48);
  a37=(a13*a46);
  a41=(a19*a43);
  a37=(a37+a41);
  a41=(a11*a39);
  a37=(a37+a41);
  a41=(a22*a45);
  a37=(a37-a41);
  a41=(a40*a37);
  a38=(a19*a45);
  a49=(a22*a43);
  a38=(a38+a49);
  a49=(a11*a46);
  a38=(a38+a49);
  a49=(a13*a39);
  a38=(a38-a49);
  a11=(a11*a43);
  a45=(a13*a45);
  a11=(a11-a45);
  a39=(a19*a39);
  a11=(a11-a39);
  a46=(a22*a46);
  a11=(a11-a46);
  a46=(2.*a11);
  a39=(a38*a46);
  a45=(a41+a39);
  a43=arg[6]? arg[6][1] : 0;
  a49=arg[6]? arg[6][3] : 0;
  a50=(a43*a49);
  a50=(2.*a50);
  a51=arg[6]? arg[6][0] : 0;
  a52=(2.*a51);
  a53=arg[6]? arg[6][2] : 0;
  a54=(a52*a53);
  a50=(a50-a54);
  a55=(a45*a50);
  a55=(a04*a55);
  a21=(a21+a55);
  a11=casadi_sq(a11);
  a55=casadi_sq(a48);
  a56=casadi_sq(a38);
  a57=(a55-a56);
  a58=(a11+a57);
  a59=casadi_sq(a37);
  a58=(a58-a59);
  a60=(a52*a43);
  a61=(2.*a49);
  a62=(a61*a53);
  a62=(a60+a62);
  a63=(a58*a62);
  a63=(a04*a63);
  a21=(a21+a63);
  a40=(a40*a38);
  a63=(a46*a37);
  a64=(a40-a63);
  a65=casadi_sq(a49);
  a66=casadi_sq(a53);
  a67=(a65-a66);
  a51=casadi_sq(a51);
  a68=casadi_sq(a43);
  a69=(a51-a68);
  a67=(a67+a69);
  a70=(a64*a67);
  a70=(a04*a70);
  a21=(a21+a70);
  a52=(a52*a49);
  a70=(a43*a53);
  a70=(2.*a70);
  a71=(a52+a70);
  a72=(a42*a17);
  a73=(a05*a12);
  a72=(a72+a73);
  a73=(a47*a14);
  a72=(a72-a73);
  a73=(a44*a16);
  a72=(a72-a73);
  a73=(a42*a14);
  a74=(a47*a17);
  a73=(a73+a74);
  a74=(a05*a16);
  a73=(a73-a74);
  a74=(a44*a12);
  a73=(a73-a74);
  a74=(a72*a73);
  a74=(2.*a74);
  a75=(a42*a16);
  a76=(a05*a14);
  a75=(a75+a76);
  a76=(a47*a12);
  a75=(a75+a76);
  a76=(a44*a17);
  a75=(a75+a76);
  a76=(2.*a75);
  a42=(a42*a12);
  a44=(a44*a14);
  a42=(a42+a44);
  a05=(a05*a17);
  a42=(a42-a05);
  a47=(a47*a16);
  a42=(a42-a47);
  a47=(a76*a42);
  a74=(a74-a47);
  a05=(a71*a74);
  a05=(a04*a05);
  a21=(a21+a05);
  a53=(a53*a49);
  a53=(2.*a53);
  a53=(a53-a60);
  a60=casadi_sq(a72);
  a49=casadi_sq(a42);
  a05=(a60-a49);
  a75=casadi_sq(a75);
  a44=casadi_sq(a73);
  a77=(a75-a44);
  a05=(a05+a77);
  a78=(a53*a05);
  a78=(a04*a78);
  a21=(a21+a78);
  a69=(a66+a69);
  a69=(a69-a65);
  a78=(a76*a73);
  a79=(2.*a72);
  a80=(a42*a79);
  a80=(a78+a80);
  a81=(a69*a80);
  a81=(a04*a81);
  a21=(a21+a81);
  a38=(a38*a37);
  a38=(2.*a38);
  a46=(a46*a48);
  a48=(a38-a46);
  a37=(a04*a71);
  a81=(a48*a37);
  a21=(a21-a81);
  a81=(a59-a11);
  a81=(a81+a57);
  a57=(a04*a53);
  a82=(a81*a57);
  a21=(a21+a82);
  a40=(a40+a63);
  a63=(a04*a69);
  a82=(a40*a63);
  a21=(a21-a82);
  a76=(a72*a76);
  a82=(a73*a42);
  a82=(2.*a82);
  a83=(a76+a82);
  a84=(a04*a50);
  a85=(a83*a84);
  a21=(a21-a85);
  a77=(a49+a77);
  a77=(a77-a60);
  a85=(a04*a62);
  a86=(a77*a85);
  a21=(a21-a86);
  a72=(a72*a42);
  a72=(2.*a72);
  a72=(a72-a78);
  a78=(a04*a67);
  a42=(a72*a78);
  a21=(a21-a42);
  a42=casadi_sq(a14);
  a86=casadi_sq(a12);
  a87=(a42-a86);
  a88=casadi_sq(a16);
  a89=casadi_sq(a17);
  a90=(a88-a89);
  a87=(a87+a90);
  a87=(a26*a87);
  a87=(a87-a24);
  a24=(a14*a12);
  a24=(2.*a24);
  a16=(2.*a16);
  a91=(a16*a17);
  a24=(a24-a91);
  a24=(a03*a24);
  a87=(a87+a24);
  a24=(a16*a12);
  a92=(2.*a14);
  a93=(a92*a17);
  a93=(a24+a93);
  a93=(a33*a93);
  a87=(a87+a93);
  a87=(a00*a87);
  a21=(a21-a87);
  if (res[0]!=0) res[0][0]=a21;
  a21=arg[2]? arg[2][0] : 0;
  a87=6.3354393272928204e+06;
  a15=(a15*a09);
  a87=(a87/a15);
  a18=(a18+a87);
  a21=(a21/a18);
  a34=(a13*a34);
  a08=(a08+a34);
  a08=(a25*a08);
  a08=(a21+a08);
  a34=(a28-a27);
  a34=(a34+a32);
  a34=(a02*a34);
  a08=(a08-a34);
  a13=(a13*a22);
  a13=(2.*a13);
  a19=(a19*a10);
  a10=(a13-a19);
  a10=(a29*a10);
  a08=(a08+a10);
  a08=(a01*a08);
  a51=(a51-a66);
  a51=(a51+a68);
  a51=(a51-a65);
  a48=(a48*a51);
  a48=(a04*a48);
  a08=(a08+a48);
  a61=(a61*a43);
  a54=(a54+a61);
  a81=(a81*a54);
  a81=(a04*a81);
  a08=(a08-a81);
  a70=(a70-a52);
  a40=(a40*a70);
  a40=(a04*a40);
  a08=(a08+a40);
  a82=(a82-a76);
  a62=(a82*a62);
  a62=(a04*a62);
  a08=(a08+a62);
  a75=(a75-a49);
  a75=(a75+a44);
  a75=(a75-a60);
  a50=(a75*a50);
  a50=(a04*a50);
  a08=(a08+a50);
  a73=(a73*a79);
  a47=(a47+a73);
  a67=(a47*a67);
  a67=(a04*a67);
  a08=(a08+a67);
  a67=(a04*a70);
  a80=(a67*a80);
  a08=(a08-a80);
  a80=(a04*a54);
  a05=(a80*a05);
  a08=(a08-a05);
  a05=(a04*a51);
  a74=(a05*a74);
  a08=(a08-a74);
  a41=(a41-a39);
  a85=(a41*a85);
  a08=(a08-a85);
  a55=(a55-a11);
  a55=(a55+a56);
  a55=(a55-a59);
  a84=(a55*a84);
  a08=(a08+a84);
  a46=(a46+a38);
  a78=(a46*a78);
  a08=(a08-a78);
  a92=(a92*a12);
  a91=(a91+a92);
  a91=(a26*a91);
  a21=(a21+a91);
  a91=(a86-a42);
  a91=(a91+a90);
  a91=(a03*a91);
  a21=(a21+a91);
  a12=(a12*a17);
  a12=(2.*a12);
  a16=(a16*a14);
  a91=(a12-a16);
  a91=(a33*a91);
  a21=(a21+a91);
  a21=(a00*a21);
  a08=(a08-a21);
  if (res[0]!=0) res[0][1]=a08;
  a06=(a06*a23);
  a23=(a23/a07);
  a20=(a20*a23);
  a06=(a06+a20);
  a35=(a35-a36);
  a25=(a25*a35);
  a25=(a06+a25);
  a13=(a13+a19);
  a02=(a02*a13);
  a25=(a25+a02);
  a27=(a27+a28);
  a30=(a30-a27);
  a30=(a30+a31);
  a29=(a29*a30);
  a25=(a25+a29);
  a01=(a01*a25);
  a70=(a70*a77);
  a70=(a04*a70);
  a01=(a01+a70);
  a54=(a54*a72);
  a54=(a04*a54);
  a01=(a01+a54);
  a51=(a51*a83);
  a51=(a04*a51);
  a01=(a01+a51);
  a41=(a41*a69);
  a41=(a04*a41);
  a01=(a01+a41);
  a55=(a55*a71);
  a55=(a04*a55);
  a01=(a01-a55);
  a46=(a46*a53);
  a04=(a04*a46);
  a01=(a01+a04);
  a45=(a45*a05);
  a01=(a01-a45);
  a37=(a37*a75);
  a01=(a01-a37);
  a57=(a57*a47);
  a01=(a01-a57);
  a58=(a58*a67);
  a01=(a01-a58);
  a64=(a64*a80);
  a01=(a01-a64);
  a63=(a63*a82);
  a01=(a01-a63);
  a14=(a14*a17);
  a14=(2.*a14);
  a14=(a14-a24);
  a26=(a26*a14);
  a06=(a06+a26);
  a16=(a16+a12);
  a03=(a03*a16);
  a06=(a06+a03);
  a42=(a42+a86);
  a88=(a88-a42);
  a88=(a88+a89);
  a33=(a33*a88);
  a06=(a06+a33);
  a00=(a00*a06);
  a01=(a01-a00);
  if (res[0]!=0) res[0][2]=a01;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_dcm_exact_h_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_dcm_exact_h_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_dcm_exact_h_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_dcm_exact_h_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_dcm_exact_h_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_dcm_exact_h_casadi_n_in(void) { return 8;}

CASADI_SYMBOL_EXPORT casadi_int va_dcm_exact_h_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real va_dcm_exact_h_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_dcm_exact_h_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "position";
    case 2: return "v_n";
    case 3: return "q_b2n_wxyz";
    case 4: return "q_b2m_wxyz";
    case 5: return "omega_ib_b";
    case 6: return "q_m2n_wxyz";
    case 7: return "lag";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_dcm_exact_h_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_dcm_exact_h_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    case 4: return casadi_s2;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    case 7: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_dcm_exact_h_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_dcm_exact_h_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_dcm_exact_h_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


