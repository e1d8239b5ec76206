/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) ahr_strapdown_casadi__ ## ID
#endif

#include <math.h>
#include "../src/ahr_math.h"
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
CASADI_SYMBOL_EXPORT void ahr_strapdown_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int ahr_strapdown_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int ahr_strapdown_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* ahr_strapdown_casadi:(lon_lat_height[3],v_n[3],q_b2n_wxyz[4],gyro_bias[3],accel_bias[3],dt,dtheta_ib_b[3],dv_b[3],dtheta_before[3],dv_before[3])->(out_lon_lat_height[3],out_v_n[3],out_q_b2n_wxyz[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
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
  a26=arg[7]? arg[7][1] : 0;
  a27=arg[7]? arg[7][0] : 0;
  a28=arg[4]? arg[4][0] : 0;
  a28=(a28*a01);
  a29=(a27-a28);
  a30=arg[3]? arg[3][2] : 0;
  a30=(a30*a01);
  a31=arg[6]? arg[6][2] : 0;
  a32=(a30-a31);
  a33=(a29*a32);
  a34=(a04*a33);
  a34=(a26-a34);
  a35=arg[3]? arg[3][0] : 0;
  a35=(a35*a01);
  a36=arg[6]? arg[6][0] : 0;
  a37=(a35-a36);
  a38=arg[7]? arg[7][2] : 0;
  a39=arg[4]? arg[4][2] : 0;
  a39=(a39*a01);
  a40=(a38-a39);
  a41=(a37*a40);
  a42=(a04*a41);
  a34=(a34+a42);
  a42=arg[9]? arg[9][0] : 0;
  a43=(a28-a42);
  a44=8.3333333333333329e-02;
  a45=(a44*a32);
  a46=(a43*a45);
  a34=(a34-a46);
  a46=arg[8]? arg[8][0] : 0;
  a46=(a35-a46);
  a47=(a44*a40);
  a48=(a46*a47);
  a34=(a34+a48);
  a48=1.6666666666666666e-01;
  a49=arg[3]? arg[3][1] : 0;
  a49=(a49*a01);
  a50=arg[6]? arg[6][1] : 0;
  a51=(a49-a50);
  a52=(a51*a29);
  a53=arg[4]? arg[4][1] : 0;
  a53=(a53*a01);
  a54=(a26-a53);
  a55=(a54*a37);
  a56=(a52-a55);
  a57=(a48*a56);
  a58=(a37*a57);
  a34=(a34+a58);
  a29=(a44*a29);
  a58=arg[8]? arg[8][2] : 0;
  a58=(a30-a58);
  a59=(a29*a58);
  a34=(a34-a59);
  a59=(a54*a32);
  a40=(a51*a40);
  a60=(a59-a40);
  a61=(a48*a60);
  a62=(a32*a61);
  a34=(a34-a62);
  a34=(a34-a53);
  a62=(a44*a37);
  a63=arg[9]? arg[9][2] : 0;
  a64=(a39-a63);
  a65=(a62*a64);
  a34=(a34+a65);
  a65=2.;
  a66=arg[2]? arg[2][1] : 0;
  a67=arg[2]? arg[2][2] : 0;
  a68=(a66*a67);
  a68=(a65*a68);
  a69=arg[2]? arg[2][0] : 0;
  a70=(a65*a69);
  a71=arg[2]? arg[2][3] : 0;
  a72=(a70*a71);
  a73=(a68-a72);
  a74=(a34*a73);
  a75=(a04*a74);
  a75=(a25+a75);
  a55=(a04*a55);
  a55=(a38-a55);
  a52=(a04*a52);
  a55=(a55+a52);
  a61=(a51*a61);
  a55=(a55+a61);
  a54=(a44*a54);
  a61=(a46*a54);
  a55=(a55-a61);
  a41=(a41-a33);
  a48=(a48*a41);
  a37=(a37*a48);
  a55=(a55-a37);
  a37=arg[8]? arg[8][1] : 0;
  a37=(a49-a37);
  a29=(a37*a29);
  a55=(a55+a29);
  a29=arg[9]? arg[9][1] : 0;
  a53=(a53-a29);
  a33=(a53*a62);
  a55=(a55-a33);
  a55=(a55-a39);
  a39=(a44*a51);
  a43=(a43*a39);
  a55=(a55+a43);
  a43=(a70*a67);
  a33=(a65*a66);
  a33=(a33*a71);
  a61=(a43+a33);
  a52=(a55*a61);
  a76=(a04*a52);
  a75=(a75+a76);
  a40=(a04*a40);
  a40=(a27-a40);
  a59=(a04*a59);
  a40=(a40+a59);
  a51=(a51*a57);
  a40=(a40-a51);
  a64=(a39*a64);
  a40=(a40-a64);
  a54=(a54*a58);
  a40=(a40+a54);
  a32=(a32*a48);
  a40=(a40+a32);
  a47=(a37*a47);
  a40=(a40-a47);
  a40=(a40-a28);
  a53=(a53*a45);
  a40=(a40+a53);
  a53=(a66*a66);
  a28=(a69*a69);
  a47=(a71*a71);
  a32=(a28-a47);
  a48=(a53+a32);
  a54=(a67*a67);
  a48=(a48-a54);
  a64=(a40*a48);
  a51=(a04*a64);
  a75=(a75+a51);
  a51=(a67*a71);
  a65=(a65*a51);
  a70=(a70*a66);
  a51=(a65-a70);
  a57=(a51*a55);
  a59=(a04*a57);
  a59=(a11+a59);
  a72=(a72+a68);
  a68=(a72*a40);
  a76=(a04*a68);
  a59=(a59+a76);
  a76=(a54-a53);
  a76=(a76+a32);
  a32=(a76*a34);
  a77=(a04*a32);
  a59=(a59+a77);
  a77=1.4584230000000000e-04;
  a78=(a77*a13);
  a16=(a02/a16);
  a08=(a08*a16);
  a08=(a03+a08);
  a08=(a25/a08);
  a79=cos(a10);
  a13=(a13/a79);
  a13=(a08*a13);
  a78=(a78+a13);
  a13=(a78*a25);
  a17=(a17*a06);
  a13=(a13+a17);
  a13=(a05*a13);
  a13=(a59-a13);
  a78=(a78*a11);
  a79=(a77*a79);
  a08=(a08+a79);
  a79=(a08*a06);
  a78=(a78-a79);
  a78=(a05*a78);
  a78=(a75+a78);
  a23=(a78*a23);
  a18=cos(a18);
  a79=(a02/a18);
  a17=(a19*a79);
  a17=(a23*a17);
  a80=(a77*a19);
  a80=(a17+a80);
  a81=(a13*a80);
  a70=(a70+a65);
  a34=(a34*a70);
  a65=(a04*a34);
  a65=(a06+a65);
  a28=(a28-a53);
  a28=(a28+a47);
  a28=(a28-a54);
  a55=(a28*a55);
  a54=(a04*a55);
  a65=(a65+a54);
  a33=(a33-a43);
  a40=(a40*a33);
  a43=(a04*a40);
  a65=(a65+a43);
  a43=(a11*a11);
  a43=(a43*a15);
  a08=(a08*a25);
  a43=(a43+a08);
  a08=9.7803253359000006e+00;
  a15=1.8894147482439335e-02;
  a54=(a15*a14);
  a54=(a08+a54);
  a54=(a54*a16);
  a16=7.3745167729419953e-14;
  a47=(a03*a03);
  a47=(a16*a47);
  a47=(a02+a47);
  a53=1.5678559428873979e-07;
  a82=2.0136051943431768e+00;
  a83=1.3411242658989924e-02;
  a14=(a83*a14);
  a14=(a82-a14);
  a14=(a03*a14);
  a14=(a53*a14);
  a47=(a47-a14);
  a54=(a54*a47);
  a43=(a43-a54);
  a43=(a05*a43);
  a43=(a65+a43);
  a77=(a77*a18);
  a77=(a23+a77);
  a54=(a43*a77);
  a81=(a81-a54);
  a81=(a01*a81);
  a54=(a04*a81);
  a75=(a75+a54);
  a57=(a57+a68);
  a57=(a57+a32);
  a32=2.5000000000000000e-01;
  a32=(a32*a01);
  a68=7.2921149999999999e-05;
  a19=(a68*a19);
  a17=(a17+a19);
  a19=(a32*a17);
  a54=(a57*a19);
  a75=(a75+a54);
  a41=(a44*a41);
  a29=(a44*a29);
  a41=(a41-a29);
  a26=(a44*a26);
  a41=(a41+a26);
  a73=(a41*a73);
  a75=(a75-a73);
  a56=(a44*a56);
  a63=(a44*a63);
  a56=(a56-a63);
  a38=(a44*a38);
  a56=(a56+a38);
  a61=(a56*a61);
  a75=(a75-a61);
  a60=(a44*a60);
  a42=(a44*a42);
  a60=(a60-a42);
  a44=(a44*a27);
  a60=(a60+a44);
  a48=(a60*a48);
  a75=(a75-a48);
  a68=(a68*a18);
  a23=(a23+a68);
  a34=(a34+a55);
  a34=(a34+a40);
  a40=(a23*a34);
  a55=(a32*a40);
  a75=(a75-a55);
  a24=(a24*a75);
  a24=(a24*a79);
  a00=(a00+a24);
  if (res[0]!=0) res[0][0]=a00;
  a09=(a09*a21);
  a12=(a12/a09);
  a12=(a07+a12);
  a09=(a02/a12);
  a21=(a01*a09);
  a43=(a43*a09);
  a43=(a43*a13);
  a80=(a78*a80);
  a43=(a43+a80);
  a43=(a01*a43);
  a80=(a04*a43);
  a59=(a59-a80);
  a09=(a13*a09);
  a80=(a32*a09);
  a00=(a34*a80);
  a59=(a59-a00);
  a76=(a41*a76);
  a59=(a59-a76);
  a51=(a56*a51);
  a59=(a59-a51);
  a72=(a60*a72);
  a59=(a59-a72);
  a74=(a74+a52);
  a74=(a74+a64);
  a19=(a19*a74);
  a59=(a59-a19);
  a21=(a21*a59);
  a10=(a10+a21);
  if (res[0]!=0) res[0][1]=a10;
  a77=(a77*a78);
  a78=(a09*a13);
  a77=(a77+a78);
  a15=(a15*a20);
  a08=(a08+a15);
  a08=(a08*a22);
  a22=(a07*a07);
  a16=(a16*a22);
  a16=(a02+a16);
  a83=(a83*a20);
  a82=(a82-a83);
  a07=(a07*a82);
  a53=(a53*a07);
  a16=(a16-a53);
  a08=(a08*a16);
  a77=(a77-a08);
  a77=(a01*a77);
  a08=(a04*a77);
  a65=(a65+a08);
  a08=(a23*a74);
  a32=(a32*a08);
  a65=(a65+a32);
  a28=(a28*a56);
  a65=(a65-a28);
  a41=(a41*a70);
  a65=(a65-a41);
  a60=(a60*a33);
  a65=(a65-a60);
  a80=(a57*a80);
  a65=(a65+a80);
  a65=(a01*a65);
  a03=(a03+a65);
  if (res[0]!=0) res[0][2]=a03;
  a81=(a81+a74);
  a81=(a81+a25);
  a25=(a05*a17);
  a03=(a57*a25);
  a81=(a81+a03);
  a40=(a05*a40);
  a81=(a81-a40);
  if (res[1]!=0) res[1][0]=a81;
  a43=(a57-a43);
  a43=(a43+a11);
  a11=(a05*a09);
  a81=(a34*a11);
  a43=(a43-a81);
  a74=(a74*a25);
  a43=(a43-a74);
  if (res[1]!=0) res[1][1]=a43;
  a34=(a34+a77);
  a34=(a34+a06);
  a05=(a05*a08);
  a34=(a34+a05);
  a57=(a57*a11);
  a34=(a34+a57);
  if (res[1]!=0) res[1][2]=a34;
  a34=1.0000000000000001e-30;
  a57=(a01*a01);
  a11=(a23*a23);
  a11=(a57*a11);
  a11=(a34+a11);
  a05=(a17*a17);
  a05=(a57*a05);
  a11=(a11+a05);
  a13=(a13*a13);
  a57=(a57*a13);
  a12=(a12*a12);
  a57=(a57/a12);
  a11=(a11+a57);
  a11=sqrt(a11);
  a57=(a04*a11);
  a12=sin(a57);
  a11=(a02/a11);
  a13=(a12*a11);
  a13=(a13*a01);
  a05=(a39*a58);
  a36=(a36-a05);
  a05=(a45*a37);
  a36=(a36+a05);
  a36=(a36-a35);
  a35=(a36*a36);
  a34=(a34+a35);
  a45=(a46*a45);
  a50=(a50-a45);
  a58=(a62*a58);
  a50=(a50+a58);
  a50=(a50-a49);
  a49=(a50*a50);
  a34=(a34+a49);
  a39=(a39*a46);
  a31=(a31+a39);
  a37=(a37*a62);
  a31=(a31-a37);
  a31=(a31-a30);
  a30=(a31*a31);
  a34=(a34+a30);
  a34=sqrt(a34);
  a04=(a04*a34);
  a30=cos(a04);
  a37=(a30*a67);
  a04=sin(a04);
  a04=(a04/a34);
  a36=(a36*a04);
  a34=(a36*a71);
  a37=(a37+a34);
  a50=(a50*a04);
  a34=(a50*a69);
  a37=(a37+a34);
  a31=(a31*a04);
  a04=(a31*a66);
  a37=(a37-a04);
  a04=(a13*a37);
  a34=(a23*a04);
  a62=(a30*a71);
  a39=(a50*a66);
  a62=(a62+a39);
  a39=(a31*a69);
  a62=(a62+a39);
  a39=(a36*a67);
  a62=(a62-a39);
  a39=(a13*a62);
  a46=(a17*a39);
  a34=(a34+a46);
  a46=(a30*a69);
  a49=(a36*a66);
  a46=(a46-a49);
  a49=(a50*a67);
  a46=(a46-a49);
  a49=(a31*a71);
  a46=(a46-a49);
  a57=cos(a57);
  a49=(a46*a57);
  a34=(a34+a49);
  a30=(a30*a66);
  a36=(a36*a69);
  a30=(a30+a36);
  a31=(a31*a67);
  a30=(a30+a31);
  a50=(a50*a71);
  a30=(a30-a50);
  a50=(a09*a13);
  a71=(a30*a50);
  a34=(a34-a71);
  a71=(a34*a34);
  a31=(a57*a62);
  a67=(a23*a30);
  a67=(a67*a11);
  a67=(a67*a12);
  a67=(a67*a01);
  a31=(a31+a67);
  a67=(a09*a04);
  a31=(a31+a67);
  a67=(a17*a13);
  a36=(a46*a67);
  a31=(a31-a36);
  a36=(a31*a31);
  a71=(a71+a36);
  a37=(a57*a37);
  a09=(a09*a11);
  a09=(a09*a12);
  a09=(a09*a62);
  a09=(a09*a01);
  a37=(a37-a09);
  a67=(a30*a67);
  a37=(a37-a67);
  a67=(a23*a46);
  a67=(a67*a13);
  a37=(a37-a67);
  a67=(a37*a37);
  a71=(a71+a67);
  a17=(a17*a04);
  a57=(a57*a30);
  a17=(a17+a57);
  a23=(a23*a39);
  a17=(a17-a23);
  a46=(a46*a50);
  a17=(a17+a46);
  a46=(a17*a17);
  a71=(a71+a46);
  a71=sqrt(a71);
  a02=(a02/a71);
  a34=(a34*a02);
  if (res[2]!=0) res[2][0]=a34;
  a17=(a17*a02);
  if (res[2]!=0) res[2][1]=a17;
  a37=(a37*a02);
  if (res[2]!=0) res[2][2]=a37;
  a31=(a31*a02);
  if (res[2]!=0) res[2][3]=a31;
  return 0;
}

CASADI_SYMBOL_EXPORT int ahr_strapdown_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ahr_strapdown_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ahr_strapdown_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ahr_strapdown_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void ahr_strapdown_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ahr_strapdown_casadi_n_in(void) { return 10;}

CASADI_SYMBOL_EXPORT casadi_int ahr_strapdown_casadi_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real ahr_strapdown_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ahr_strapdown_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
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

CASADI_SYMBOL_EXPORT const char* ahr_strapdown_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_lon_lat_height";
    case 1: return "out_v_n";
    case 2: return "out_q_b2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ahr_strapdown_casadi_sparsity_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const casadi_int* ahr_strapdown_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ahr_strapdown_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ahr_strapdown_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


