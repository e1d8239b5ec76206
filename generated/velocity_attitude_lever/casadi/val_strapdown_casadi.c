/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) val_strapdown_casadi__ ## ID
#endif

#include <math.h>
#include "../src/val_math.h"
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
CASADI_SYMBOL_EXPORT void val_strapdown_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int val_strapdown_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int val_strapdown_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* val_strapdown_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],gyro_bias[3],accel_bias[3],dt,dtheta_ib_b[3],dv_b[3],dtheta_before[3],dv_before[3])->(out_lat_lon_height[3],out_v_n[3],out_q_b2n_wxyz[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=1.;
  a03=arg[0]? arg[0][2] : 0;
  a04=5.0000000000000000e-01;
  a05=(a04*a01);
  a06=arg[1]? arg[1][2] : 0;
  a07=(a05*a06);
  a07=(a03-a07);
  a08=6.3354393272928204e+06;
  a09=6.6943799901413173e-03;
  a10=arg[1]? arg[1][0] : 0;
  a11=sin(a00);
  a12=(a11*a11);
  a13=(a09*a12);
  a13=(a02-a13);
  a14=sqrt(a13);
  a13=(a13*a14);
  a13=(a08/a13);
  a13=(a03+a13);
  a13=(a02/a13);
  a15=(a10*a13);
  a16=(a05*a15);
  a16=(a00+a16);
  a17=sin(a16);
  a18=(a17*a17);
  a09=(a09*a18);
  a09=(a02-a09);
  a19=sqrt(a09);
  a09=(a09*a19);
  a08=(a08/a09);
  a08=(a07+a08);
  a09=(a02/a08);
  a20=(a01*a09);
  a21=arg[7]? arg[7][1] : 0;
  a22=arg[3]? arg[3][2] : 0;
  a22=(a22*a01);
  a23=arg[6]? arg[6][2] : 0;
  a24=(a22-a23);
  a25=arg[7]? arg[7][0] : 0;
  a26=arg[4]? arg[4][0] : 0;
  a26=(a26*a01);
  a27=(a25-a26);
  a28=(a24*a27);
  a29=(a04*a28);
  a29=(a21-a29);
  a30=arg[7]? arg[7][2] : 0;
  a31=arg[4]? arg[4][2] : 0;
  a31=(a31*a01);
  a32=(a30-a31);
  a33=arg[3]? arg[3][0] : 0;
  a33=(a33*a01);
  a34=arg[6]? arg[6][0] : 0;
  a35=(a33-a34);
  a36=(a32*a35);
  a37=(a04*a36);
  a29=(a29+a37);
  a37=1.6666666666666666e-01;
  a38=arg[4]? arg[4][1] : 0;
  a38=(a38*a01);
  a39=(a21-a38);
  a40=(a24*a39);
  a41=arg[3]? arg[3][1] : 0;
  a41=(a41*a01);
  a42=arg[6]? arg[6][1] : 0;
  a43=(a41-a42);
  a44=(a32*a43);
  a45=(a40-a44);
  a46=(a37*a45);
  a47=(a24*a46);
  a29=(a29-a47);
  a47=8.3333333333333329e-02;
  a48=(a47*a24);
  a49=arg[9]? arg[9][0] : 0;
  a50=(a26-a49);
  a51=(a48*a50);
  a29=(a29-a51);
  a32=(a47*a32);
  a51=arg[8]? arg[8][0] : 0;
  a51=(a33-a51);
  a52=(a32*a51);
  a29=(a29+a52);
  a52=(a43*a27);
  a53=(a39*a35);
  a54=(a52-a53);
  a55=(a37*a54);
  a56=(a35*a55);
  a29=(a29+a56);
  a56=arg[8]? arg[8][2] : 0;
  a56=(a22-a56);
  a27=(a47*a27);
  a57=(a56*a27);
  a29=(a29-a57);
  a29=(a29-a38);
  a57=arg[9]? arg[9][2] : 0;
  a58=(a31-a57);
  a59=(a47*a35);
  a60=(a58*a59);
  a29=(a29+a60);
  a60=2.;
  a61=arg[2]? arg[2][1] : 0;
  a62=arg[2]? arg[2][2] : 0;
  a63=(a61*a62);
  a63=(a60*a63);
  a64=arg[2]? arg[2][0] : 0;
  a65=(a60*a64);
  a66=arg[2]? arg[2][3] : 0;
  a67=(a65*a66);
  a68=(a63-a67);
  a69=(a29*a68);
  a70=(a04*a69);
  a70=(a10+a70);
  a53=(a04*a53);
  a53=(a30-a53);
  a52=(a04*a52);
  a53=(a53+a52);
  a52=arg[9]? arg[9][1] : 0;
  a38=(a38-a52);
  a71=(a38*a59);
  a53=(a53-a71);
  a71=arg[8]? arg[8][1] : 0;
  a71=(a41-a71);
  a27=(a71*a27);
  a53=(a53+a27);
  a46=(a43*a46);
  a53=(a53+a46);
  a39=(a47*a39);
  a46=(a39*a51);
  a53=(a53-a46);
  a36=(a36-a28);
  a37=(a37*a36);
  a35=(a35*a37);
  a53=(a53-a35);
  a53=(a53-a31);
  a31=(a47*a43);
  a50=(a31*a50);
  a53=(a53+a50);
  a50=(a65*a62);
  a35=(a61*a66);
  a35=(a60*a35);
  a28=(a50+a35);
  a46=(a53*a28);
  a27=(a04*a46);
  a70=(a70+a27);
  a44=(a04*a44);
  a44=(a25-a44);
  a40=(a04*a40);
  a44=(a44+a40);
  a24=(a24*a37);
  a44=(a44+a24);
  a32=(a71*a32);
  a44=(a44-a32);
  a43=(a43*a55);
  a44=(a44-a43);
  a39=(a56*a39);
  a44=(a44+a39);
  a58=(a58*a31);
  a44=(a44-a58);
  a44=(a44-a26);
  a38=(a38*a48);
  a44=(a44+a38);
  a38=(a64*a64);
  a26=(a62*a62);
  a58=(a38-a26);
  a39=(a61*a61);
  a58=(a58+a39);
  a43=(a66*a66);
  a58=(a58-a43);
  a55=(a44*a58);
  a32=(a04*a55);
  a70=(a70+a32);
  a32=arg[1]? arg[1][1] : 0;
  a38=(a38-a39);
  a39=(a26+a38);
  a39=(a39-a43);
  a24=(a39*a29);
  a37=(a04*a24);
  a37=(a32+a37);
  a40=(a62*a66);
  a60=(a60*a40);
  a65=(a65*a61);
  a40=(a60-a65);
  a27=(a53*a40);
  a72=(a04*a27);
  a37=(a37+a72);
  a67=(a67+a63);
  a63=(a44*a67);
  a72=(a04*a63);
  a37=(a37+a72);
  a72=6378137.;
  a14=(a02/a14);
  a73=(a72*a14);
  a73=(a03+a73);
  a73=(a32/a73);
  a74=1.4584230000000000e-04;
  a75=cos(a00);
  a76=(a74*a75);
  a76=(a73+a76);
  a77=(a76*a06);
  a78=(a74*a11);
  a11=(a11/a75);
  a73=(a73*a11);
  a78=(a78+a73);
  a73=(a78*a10);
  a77=(a77+a73);
  a77=(a05*a77);
  a77=(a37+a77);
  a19=(a02/a19);
  a72=(a72*a19);
  a72=(a07+a72);
  a72=(a02/a72);
  a73=(a77*a72);
  a16=cos(a16);
  a11=(a02/a16);
  a75=(a17*a11);
  a75=(a73*a75);
  a79=(a74*a17);
  a79=(a75+a79);
  a80=(a77*a79);
  a35=(a35-a50);
  a44=(a35*a44);
  a50=(a04*a44);
  a50=(a06+a50);
  a65=(a65+a60);
  a29=(a65*a29);
  a60=(a04*a29);
  a50=(a50+a60);
  a43=(a43-a26);
  a43=(a43+a38);
  a53=(a43*a53);
  a38=(a04*a53);
  a50=(a50+a38);
  a38=9.7803253359000006e+00;
  a26=1.8894147482439335e-02;
  a60=(a26*a12);
  a60=(a38+a60);
  a60=(a60*a14);
  a14=7.3745167729419953e-14;
  a81=(a03*a03);
  a81=(a14*a81);
  a81=(a02+a81);
  a82=1.5678559428873979e-07;
  a83=2.0136051943431768e+00;
  a84=1.3411242658989924e-02;
  a12=(a84*a12);
  a12=(a83-a12);
  a12=(a03*a12);
  a12=(a82*a12);
  a81=(a81-a12);
  a60=(a60*a81);
  a76=(a76*a32);
  a60=(a60-a76);
  a76=(a10*a10);
  a76=(a76*a13);
  a60=(a60-a76);
  a60=(a05*a60);
  a60=(a50+a60);
  a15=(a15*a06);
  a78=(a78*a32);
  a15=(a15-a78);
  a15=(a05*a15);
  a15=(a70+a15);
  a78=(a15*a09);
  a76=(a60*a78);
  a80=(a80-a76);
  a80=(a01*a80);
  a76=(a04*a80);
  a70=(a70-a76);
  a76=2.5000000000000000e-01;
  a13=(a76*a01);
  a81=7.2921149999999999e-05;
  a17=(a81*a17);
  a75=(a75+a17);
  a24=(a24+a27);
  a24=(a24+a63);
  a63=(a75*a24);
  a27=(a13*a63);
  a70=(a70-a27);
  a36=(a36-a52);
  a36=(a36+a21);
  a21=(a47*a36);
  a68=(a21*a68);
  a70=(a70-a68);
  a54=(a54-a57);
  a54=(a54+a30);
  a30=(a47*a54);
  a28=(a30*a28);
  a70=(a70-a28);
  a45=(a45-a49);
  a45=(a45+a25);
  a25=(a47*a45);
  a58=(a25*a58);
  a70=(a70-a58);
  a44=(a44+a29);
  a44=(a44+a53);
  a53=(a13*a78);
  a29=(a44*a53);
  a70=(a70+a29);
  a20=(a20*a70);
  a00=(a00+a20);
  if (res[0]!=0) res[0][0]=a00;
  a00=arg[0]? arg[0][1] : 0;
  a72=(a01*a72);
  a79=(a79*a15);
  a74=(a74*a16);
  a74=(a73+a74);
  a60=(a74*a60);
  a79=(a79+a60);
  a79=(a01*a79);
  a60=(a04*a79);
  a37=(a37+a60);
  a60=(a13*a44);
  a81=(a81*a16);
  a73=(a73+a81);
  a60=(a60*a73);
  a37=(a37+a60);
  a39=(a39*a21);
  a37=(a37-a39);
  a30=(a30*a40);
  a37=(a37-a30);
  a25=(a25*a67);
  a37=(a37-a25);
  a69=(a69+a46);
  a69=(a69+a55);
  a55=(a75*a69);
  a13=(a13*a55);
  a37=(a37+a13);
  a72=(a72*a37);
  a72=(a72*a11);
  a00=(a00+a72);
  if (res[0]!=0) res[0][1]=a00;
  a36=(a36*a65);
  a36=(a47*a36);
  a54=(a54*a43);
  a54=(a47*a54);
  a36=(a36+a54);
  a45=(a45*a35);
  a47=(a47*a45);
  a36=(a36+a47);
  a47=(a24*a73);
  a47=(a47*a01);
  a76=(a76*a47);
  a36=(a36+a76);
  a36=(a36-a50);
  a26=(a26*a18);
  a38=(a38+a26);
  a38=(a38*a19);
  a19=(a07*a07);
  a14=(a14*a19);
  a14=(a02+a14);
  a84=(a84*a18);
  a83=(a83-a84);
  a07=(a07*a83);
  a82=(a82*a07);
  a14=(a14-a82);
  a38=(a38*a14);
  a14=(a15*a78);
  a38=(a38-a14);
  a77=(a77*a74);
  a38=(a38-a77);
  a38=(a01*a38);
  a77=(a04*a38);
  a36=(a36-a77);
  a53=(a53*a69);
  a36=(a36+a53);
  a36=(a01*a36);
  a03=(a03+a36);
  if (res[0]!=0) res[0][2]=a03;
  a80=(a69-a80);
  a80=(a80+a10);
  a63=(a05*a63);
  a80=(a80-a63);
  a63=(a05*a78);
  a10=(a44*a63);
  a80=(a80+a10);
  if (res[1]!=0) res[1][0]=a80;
  a79=(a24+a79);
  a79=(a79+a32);
  a32=(a05*a73);
  a80=(a44*a32);
  a79=(a79+a80);
  a05=(a05*a55);
  a79=(a79+a05);
  if (res[1]!=0) res[1][1]=a79;
  a44=(a44+a38);
  a44=(a44+a06);
  a69=(a69*a63);
  a44=(a44-a69);
  a24=(a24*a32);
  a44=(a44-a24);
  if (res[1]!=0) res[1][2]=a44;
  a44=1.0000000000000001e-30;
  a24=(a48*a71);
  a34=(a34+a24);
  a24=(a56*a31);
  a34=(a34-a24);
  a34=(a34-a33);
  a33=(a34*a34);
  a33=(a44+a33);
  a48=(a48*a51);
  a42=(a42-a48);
  a56=(a56*a59);
  a42=(a42+a56);
  a42=(a42-a41);
  a41=(a42*a42);
  a33=(a33+a41);
  a71=(a71*a59);
  a23=(a23-a71);
  a31=(a31*a51);
  a23=(a23+a31);
  a23=(a23-a22);
  a22=(a23*a23);
  a33=(a33+a22);
  a33=sqrt(a33);
  a22=(a04*a33);
  a31=cos(a22);
  a51=(a31*a64);
  a22=sin(a22);
  a22=(a22/a33);
  a33=(a22*a61);
  a71=(a34*a33);
  a51=(a51-a71);
  a71=(a22*a62);
  a59=(a42*a71);
  a51=(a51-a59);
  a59=(a23*a22);
  a41=(a59*a66);
  a51=(a51-a41);
  a41=(a01*a01);
  a56=(a75*a75);
  a56=(a41*a56);
  a44=(a44+a56);
  a56=(a73*a73);
  a56=(a41*a56);
  a44=(a44+a56);
  a56=(a15*a15);
  a41=(a41*a56);
  a08=(a08*a08);
  a41=(a41/a08);
  a44=(a44+a41);
  a44=sqrt(a44);
  a04=(a04*a44);
  a41=cos(a04);
  a08=(a51*a41);
  a56=(a22*a66);
  a48=(a34*a56);
  a22=(a22*a64);
  a24=(a42*a22);
  a48=(a48+a24);
  a62=(a31*a62);
  a48=(a48+a62);
  a62=(a23*a33);
  a48=(a48-a62);
  a04=sin(a04);
  a44=(a02/a44);
  a62=(a04*a44);
  a62=(a62*a01);
  a78=(a62*a78);
  a24=(a48*a78);
  a08=(a08-a24);
  a22=(a34*a22);
  a23=(a23*a71);
  a22=(a22+a23);
  a61=(a31*a61);
  a22=(a22+a61);
  a56=(a42*a56);
  a22=(a22-a56);
  a56=(a73*a62);
  a61=(a22*a56);
  a08=(a08+a61);
  a42=(a42*a33);
  a31=(a31*a66);
  a42=(a42+a31);
  a59=(a59*a64);
  a42=(a42+a59);
  a34=(a34*a71);
  a42=(a42-a34);
  a75=(a75*a62);
  a62=(a42*a75);
  a08=(a08-a62);
  a62=(a08*a08);
  a34=(a41*a42);
  a09=(a09*a44);
  a09=(a09*a04);
  a09=(a09*a22);
  a09=(a09*a15);
  a09=(a09*a01);
  a34=(a34-a09);
  a09=(a51*a75);
  a34=(a34+a09);
  a09=(a48*a56);
  a34=(a34-a09);
  a09=(a34*a34);
  a62=(a62+a09);
  a09=(a41*a48);
  a73=(a73*a44);
  a73=(a73*a04);
  a73=(a73*a42);
  a73=(a73*a01);
  a09=(a09+a73);
  a73=(a51*a78);
  a09=(a09+a73);
  a73=(a22*a75);
  a09=(a09+a73);
  a73=(a09*a09);
  a62=(a62+a73);
  a41=(a41*a22);
  a48=(a48*a75);
  a41=(a41-a48);
  a51=(a51*a56);
  a41=(a41-a51);
  a78=(a78*a42);
  a41=(a41+a78);
  a78=(a41*a41);
  a62=(a62+a78);
  a62=sqrt(a62);
  a02=(a02/a62);
  a08=(a08*a02);
  if (res[2]!=0) res[2][0]=a08;
  a41=(a41*a02);
  if (res[2]!=0) res[2][1]=a41;
  a09=(a09*a02);
  if (res[2]!=0) res[2][2]=a09;
  a34=(a34*a02);
  if (res[2]!=0) res[2][3]=a34;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_strapdown_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int val_strapdown_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void val_strapdown_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void val_strapdown_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void val_strapdown_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int val_strapdown_casadi_n_in(void) { return 10;}

CASADI_SYMBOL_EXPORT casadi_int val_strapdown_casadi_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real val_strapdown_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_strapdown_casadi_name_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const char* val_strapdown_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_lat_lon_height";
    case 1: return "out_v_n";
    case 2: return "out_q_b2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_strapdown_casadi_sparsity_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const casadi_int* val_strapdown_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int val_strapdown_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_strapdown_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


