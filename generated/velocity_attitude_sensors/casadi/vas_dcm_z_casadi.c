/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_dcm_z_casadi__ ## ID
#endif

#include <math.h>
#include "../src/vas_math.h"
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
CASADI_SYMBOL_EXPORT void vas_dcm_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_dcm_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_dcm_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {6, 1, 1};

/* vas_dcm_z_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],q_m2n_wxyz[4],lag,flexure[3],flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67;
  a00=5.0000000000000000e-01;
  a01=2.;
  a02=arg[5]? arg[5][0] : 0;
  a03=(a01*a02);
  a04=arg[5]? arg[5][3] : 0;
  a05=(a03*a04);
  a06=arg[5]? arg[5][2] : 0;
  a07=(a01*a06);
  a08=arg[5]? arg[5][1] : 0;
  a09=(a07*a08);
  a10=(a05+a09);
  a11=arg[2]? arg[2][1] : 0;
  a12=arg[3]? arg[3][0] : 0;
  a13=1.;
  a14=2.5000000000000000e-01;
  a15=arg[7]? arg[7][0] : 0;
  a16=(a15*a15);
  a16=(a14*a16);
  a16=(a13+a16);
  a17=arg[7]? arg[7][1] : 0;
  a18=(a17*a17);
  a18=(a14*a18);
  a16=(a16+a18);
  a18=arg[7]? arg[7][2] : 0;
  a19=(a18*a18);
  a14=(a14*a19);
  a16=(a16+a14);
  a16=sqrt(a16);
  a16=(a13/a16);
  a14=(a12*a16);
  a19=arg[3]? arg[3][1] : 0;
  a20=(a00*a16);
  a15=(a20*a15);
  a21=(a19*a15);
  a14=(a14-a21);
  a21=arg[3]? arg[3][2] : 0;
  a17=(a20*a17);
  a22=(a21*a17);
  a14=(a14-a22);
  a22=arg[3]? arg[3][3] : 0;
  a20=(a20*a18);
  a18=(a22*a20);
  a14=(a14-a18);
  a18=(a11*a14);
  a23=arg[2]? arg[2][3] : 0;
  a24=(a12*a17);
  a25=(a19*a20);
  a24=(a24+a25);
  a25=(a21*a16);
  a24=(a24+a25);
  a25=(a22*a15);
  a24=(a24-a25);
  a25=(a23*a24);
  a18=(a18+a25);
  a25=arg[2]? arg[2][0] : 0;
  a26=(a12*a15);
  a27=(a19*a16);
  a26=(a26+a27);
  a27=(a22*a17);
  a26=(a26+a27);
  a27=(a21*a20);
  a26=(a26-a27);
  a27=(a25*a26);
  a18=(a18-a27);
  a27=arg[2]? arg[2][2] : 0;
  a20=(a12*a20);
  a15=(a21*a15);
  a20=(a20+a15);
  a16=(a22*a16);
  a20=(a20+a16);
  a17=(a19*a17);
  a20=(a20-a17);
  a17=(a27*a20);
  a18=(a18-a17);
  a17=(a01*a18);
  a16=(a27*a26);
  a15=(a23*a14);
  a16=(a16+a15);
  a15=(a25*a20);
  a16=(a16-a15);
  a15=(a11*a24);
  a16=(a16-a15);
  a15=(a17*a16);
  a28=(a25*a14);
  a29=(a11*a26);
  a28=(a28+a29);
  a29=(a27*a24);
  a28=(a28+a29);
  a29=(a23*a20);
  a28=(a28+a29);
  a29=(a01*a28);
  a20=(a11*a20);
  a14=(a27*a14);
  a20=(a20+a14);
  a24=(a25*a24);
  a20=(a20-a24);
  a26=(a23*a26);
  a20=(a20-a26);
  a26=(a29*a20);
  a24=(a15-a26);
  a14=(a10*a24);
  a14=(a00*a14);
  a02=(a02*a02);
  a30=(a08*a08);
  a31=(a02-a30);
  a32=(a06*a06);
  a33=(a31+a32);
  a34=(a04*a04);
  a33=(a33-a34);
  a35=(a29*a18);
  a36=(a01*a16);
  a36=(a36*a20);
  a37=(a35+a36);
  a38=(a33*a37);
  a38=(a00*a38);
  a14=(a14+a38);
  a07=(a07*a04);
  a38=(a03*a08);
  a39=(a07-a38);
  a40=(a16*a16);
  a41=(a20*a20);
  a42=(a40-a41);
  a28=(a28*a28);
  a18=(a18*a18);
  a43=(a28-a18);
  a42=(a42+a43);
  a44=(a39*a42);
  a44=(a00*a44);
  a14=(a14+a44);
  a44=arg[6]? arg[6][0] : 0;
  a45=arg[4]? arg[4][0] : 0;
  a46=arg[9]? arg[9][0] : 0;
  a46=(a13-a46);
  a46=(a45*a46);
  a47=arg[8]? arg[8][0] : 0;
  a48=(a19*a19);
  a49=(a21*a21);
  a50=(a48-a49);
  a51=(a12*a12);
  a52=(a22*a22);
  a53=(a51-a52);
  a50=(a50+a53);
  a50=(a47*a50);
  a46=(a46-a50);
  a50=arg[8]? arg[8][1] : 0;
  a12=(a01*a12);
  a54=(a12*a22);
  a55=(a01*a19);
  a56=(a55*a21);
  a57=(a54+a56);
  a57=(a50*a57);
  a46=(a46-a57);
  a57=arg[8]? arg[8][2] : 0;
  a55=(a55*a22);
  a58=(a12*a21);
  a59=(a55-a58);
  a59=(a57*a59);
  a46=(a46-a59);
  a59=arg[10]? arg[10][0] : 0;
  a60=arg[4]? arg[4][1] : 0;
  a59=(a59*a60);
  a46=(a46-a59);
  a59=arg[10]? arg[10][1] : 0;
  a61=arg[4]? arg[4][2] : 0;
  a59=(a59*a61);
  a46=(a46-a59);
  a59=(a11*a11);
  a62=(a27*a27);
  a63=(a59-a62);
  a64=(a25*a25);
  a65=(a23*a23);
  a66=(a64-a65);
  a63=(a63+a66);
  a63=(a46*a63);
  a67=arg[9]? arg[9][1] : 0;
  a67=(a13-a67);
  a67=(a60*a67);
  a56=(a56-a54);
  a56=(a47*a56);
  a67=(a67-a56);
  a53=(a49+a53);
  a53=(a53-a48);
  a53=(a50*a53);
  a67=(a67-a53);
  a12=(a12*a19);
  a21=(a01*a21);
  a21=(a21*a22);
  a22=(a12+a21);
  a22=(a57*a22);
  a67=(a67-a22);
  a22=arg[10]? arg[10][2] : 0;
  a22=(a22*a45);
  a67=(a67-a22);
  a22=arg[10]? arg[10][3] : 0;
  a22=(a22*a61);
  a67=(a67-a22);
  a22=(a01*a11);
  a19=(a22*a27);
  a25=(a01*a25);
  a53=(a25*a23);
  a56=(a19-a53);
  a56=(a67*a56);
  a63=(a63+a56);
  a56=arg[9]? arg[9][2] : 0;
  a56=(a13-a56);
  a61=(a61*a56);
  a58=(a58+a55);
  a47=(a47*a58);
  a61=(a61-a47);
  a21=(a21-a12);
  a50=(a50*a21);
  a61=(a61-a50);
  a51=(a51-a49);
  a51=(a51+a52);
  a51=(a51-a48);
  a57=(a57*a51);
  a61=(a61-a57);
  a57=arg[10]? arg[10][4] : 0;
  a57=(a57*a45);
  a61=(a61-a57);
  a57=arg[10]? arg[10][5] : 0;
  a57=(a57*a60);
  a61=(a61-a57);
  a57=(a25*a27);
  a22=(a22*a23);
  a60=(a57+a22);
  a60=(a61*a60);
  a63=(a63+a60);
  a60=arg[1]? arg[1][1] : 0;
  a45=arg[0]? arg[0][2] : 0;
  a51=6378137.;
  a48=6.6943799901413173e-03;
  a52=arg[0]? arg[0][0] : 0;
  a49=sin(a52);
  a50=(a49*a49);
  a48=(a48*a50);
  a13=(a13-a48);
  a48=sqrt(a13);
  a51=(a51/a48);
  a51=(a45+a51);
  a60=(a60/a51);
  a51=7.2921149999999999e-05;
  a52=cos(a52);
  a50=(a51*a52);
  a50=(a60+a50);
  a63=(a63-a50);
  a63=(a44*a63);
  a14=(a14-a63);
  a08=(a01*a08);
  a08=(a08*a04);
  a03=(a03*a06);
  a06=(a08-a03);
  a29=(a29*a16);
  a17=(a17*a20);
  a20=(a29+a17);
  a16=(a06*a20);
  a16=(a00*a16);
  a14=(a14-a16);
  a38=(a38+a07);
  a43=(a41+a43);
  a43=(a43-a40);
  a07=(a38*a43);
  a07=(a00*a07);
  a14=(a14-a07);
  a31=(a31-a32);
  a31=(a31+a34);
  a36=(a36-a35);
  a35=(a31*a36);
  a35=(a00*a35);
  a14=(a14-a35);
  if (res[0]!=0) res[0][0]=a14;
  a28=(a28-a41);
  a28=(a28+a18);
  a28=(a28-a40);
  a06=(a06*a28);
  a06=(a00*a06);
  a17=(a17-a29);
  a38=(a38*a17);
  a38=(a00*a38);
  a06=(a06+a38);
  a26=(a26+a15);
  a31=(a31*a26);
  a31=(a00*a31);
  a06=(a06+a31);
  a53=(a53+a19);
  a53=(a46*a53);
  a66=(a62+a66);
  a66=(a66-a59);
  a66=(a67*a66);
  a53=(a53+a66);
  a01=(a01*a27);
  a01=(a01*a23);
  a25=(a25*a11);
  a11=(a01-a25);
  a11=(a61*a11);
  a53=(a53+a11);
  a11=arg[1]? arg[1][0] : 0;
  a23=6.3354393272928204e+06;
  a13=(a13*a48);
  a23=(a23/a13);
  a45=(a45+a23);
  a11=(a11/a45);
  a53=(a53+a11);
  a53=(a44*a53);
  a06=(a06-a53);
  a02=(a02+a30);
  a02=(a02-a32);
  a02=(a02-a34);
  a24=(a02*a24);
  a24=(a00*a24);
  a06=(a06-a24);
  a09=(a09-a05);
  a37=(a09*a37);
  a37=(a00*a37);
  a06=(a06-a37);
  a03=(a03+a08);
  a42=(a03*a42);
  a42=(a00*a42);
  a06=(a06-a42);
  if (res[0]!=0) res[0][1]=a06;
  a02=(a02*a20);
  a02=(a00*a02);
  a09=(a09*a43);
  a09=(a00*a09);
  a02=(a02+a09);
  a03=(a03*a36);
  a03=(a00*a03);
  a02=(a02+a03);
  a22=(a22-a57);
  a46=(a46*a22);
  a25=(a25+a01);
  a67=(a67*a25);
  a46=(a46+a67);
  a64=(a64-a62);
  a64=(a64+a65);
  a64=(a64-a59);
  a61=(a61*a64);
  a46=(a46+a61);
  a52=(a49/a52);
  a60=(a60*a52);
  a51=(a51*a49);
  a60=(a60+a51);
  a46=(a46+a60);
  a44=(a44*a46);
  a02=(a02-a44);
  a10=(a10*a28);
  a10=(a00*a10);
  a02=(a02-a10);
  a33=(a33*a17);
  a33=(a00*a33);
  a02=(a02-a33);
  a39=(a39*a26);
  a00=(a00*a39);
  a02=(a02-a00);
  if (res[0]!=0) res[0][2]=a02;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_dcm_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_dcm_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_dcm_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_dcm_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_dcm_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_dcm_z_casadi_n_in(void) { return 11;}

CASADI_SYMBOL_EXPORT casadi_int vas_dcm_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_dcm_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_dcm_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "q_m2n_wxyz";
    case 6: return "lag";
    case 7: return "flexure";
    case 8: return "flexure_rate";
    case 9: return "gyro_scale";
    case 10: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_dcm_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_dcm_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    case 7: return casadi_s0;
    case 8: return casadi_s0;
    case 9: return casadi_s0;
    case 10: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_dcm_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_dcm_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 11;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_dcm_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


