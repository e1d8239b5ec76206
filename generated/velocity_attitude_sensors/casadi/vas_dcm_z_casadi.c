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
  casadi_real a60, a61, a62, a63, a64, a65;
  a00=5.0000000000000000e-01;
  a01=2.;
  a02=arg[5]? arg[5][0] : 0;
  a03=(a01*a02);
  a04=arg[5]? arg[5][3] : 0;
  a05=(a03*a04);
  a06=arg[5]? arg[5][2] : 0;
  a07=(a01*a06);
  a08=arg[5]? arg[5][1] : 0;
  a07=(a07*a08);
  a09=(a05+a07);
  a10=arg[3]? arg[3][2] : 0;
  a11=1.;
  a12=2.5000000000000000e-01;
  a13=arg[7]? arg[7][0] : 0;
  a14=(a13*a13);
  a14=(a12*a14);
  a14=(a11+a14);
  a15=arg[7]? arg[7][1] : 0;
  a16=(a15*a15);
  a16=(a12*a16);
  a14=(a14+a16);
  a16=arg[7]? arg[7][2] : 0;
  a17=(a16*a16);
  a12=(a12*a17);
  a14=(a14+a12);
  a14=sqrt(a14);
  a14=(a11/a14);
  a12=(a10*a14);
  a17=arg[3]? arg[3][1] : 0;
  a18=(a17*a14);
  a16=(a00*a16);
  a19=(a18*a16);
  a19=(a12+a19);
  a15=(a00*a15);
  a20=arg[3]? arg[3][0] : 0;
  a21=(a20*a14);
  a22=(a15*a21);
  a19=(a19+a22);
  a22=arg[3]? arg[3][3] : 0;
  a14=(a22*a14);
  a13=(a00*a13);
  a23=(a14*a13);
  a19=(a19-a23);
  a23=arg[2]? arg[2][3] : 0;
  a24=(a19*a23);
  a25=(a14*a16);
  a25=(a21-a25);
  a26=(a12*a15);
  a25=(a25-a26);
  a26=(a13*a18);
  a25=(a25-a26);
  a26=arg[2]? arg[2][1] : 0;
  a27=(a25*a26);
  a24=(a24+a27);
  a27=(a12*a13);
  a27=(a14+a27);
  a28=(a21*a16);
  a27=(a27+a28);
  a28=(a18*a15);
  a27=(a27-a28);
  a28=arg[2]? arg[2][2] : 0;
  a29=(a27*a28);
  a24=(a24-a29);
  a14=(a14*a15);
  a18=(a18+a14);
  a13=(a13*a21);
  a18=(a18+a13);
  a12=(a12*a16);
  a18=(a18-a12);
  a12=arg[2]? arg[2][0] : 0;
  a16=(a18*a12);
  a24=(a24-a16);
  a16=(a18*a28);
  a13=(a25*a23);
  a16=(a16+a13);
  a13=(a27*a12);
  a16=(a16-a13);
  a13=(a19*a26);
  a16=(a16-a13);
  a13=(a01*a16);
  a21=(a24*a13);
  a14=(a27*a23);
  a15=(a19*a28);
  a14=(a14+a15);
  a15=(a18*a26);
  a14=(a14+a15);
  a15=(a25*a12);
  a14=(a14+a15);
  a15=(a01*a14);
  a27=(a27*a26);
  a25=(a25*a28);
  a27=(a27+a25);
  a19=(a19*a12);
  a27=(a27-a19);
  a18=(a18*a23);
  a27=(a27-a18);
  a18=(a15*a27);
  a19=(a21-a18);
  a25=(a09*a19);
  a25=(a00*a25);
  a29=(a06*a04);
  a29=(a01*a29);
  a30=(a03*a08);
  a31=(a29-a30);
  a32=(a27*a27);
  a33=(a16*a16);
  a34=(a32-a33);
  a35=(a24*a24);
  a14=(a14*a14);
  a36=(a35-a14);
  a34=(a34+a36);
  a37=(a31*a34);
  a37=(a00*a37);
  a25=(a25-a37);
  a37=(a06*a06);
  a02=(a02*a02);
  a38=(a08*a08);
  a39=(a02-a38);
  a40=(a37+a39);
  a41=(a04*a04);
  a40=(a40-a41);
  a42=(a15*a24);
  a13=(a27*a13);
  a43=(a42+a13);
  a44=(a40*a43);
  a44=(a00*a44);
  a25=(a25+a44);
  a44=arg[6]? arg[6][0] : 0;
  a45=arg[4]? arg[4][2] : 0;
  a46=arg[9]? arg[9][2] : 0;
  a46=(a11-a46);
  a46=(a45*a46);
  a47=arg[8]? arg[8][0] : 0;
  a48=(a01*a20);
  a49=(a48*a10);
  a50=(a17*a22);
  a50=(a01*a50);
  a51=(a49+a50);
  a51=(a47*a51);
  a46=(a46-a51);
  a51=arg[8]? arg[8][1] : 0;
  a52=(a10*a22);
  a52=(a01*a52);
  a53=(a48*a17);
  a54=(a52-a53);
  a54=(a51*a54);
  a46=(a46-a54);
  a54=arg[8]? arg[8][2] : 0;
  a20=(a20*a20);
  a55=(a17*a17);
  a56=(a20-a55);
  a57=(a10*a10);
  a58=(a56-a57);
  a59=(a22*a22);
  a58=(a58+a59);
  a58=(a54*a58);
  a46=(a46-a58);
  a58=arg[10]? arg[10][4] : 0;
  a60=arg[4]? arg[4][0] : 0;
  a58=(a58*a60);
  a46=(a46-a58);
  a58=arg[10]? arg[10][5] : 0;
  a61=arg[4]? arg[4][1] : 0;
  a58=(a58*a61);
  a46=(a46-a58);
  a58=(a01*a12);
  a62=(a58*a28);
  a63=(a01*a26);
  a63=(a63*a23);
  a64=(a62+a63);
  a64=(a46*a64);
  a65=arg[9]? arg[9][1] : 0;
  a65=(a11-a65);
  a65=(a61*a65);
  a17=(a17*a10);
  a17=(a01*a17);
  a48=(a48*a22);
  a22=(a17-a48);
  a22=(a47*a22);
  a65=(a65-a22);
  a56=(a57+a56);
  a56=(a56-a59);
  a56=(a51*a56);
  a65=(a65-a56);
  a53=(a53+a52);
  a53=(a54*a53);
  a65=(a65-a53);
  a53=arg[10]? arg[10][2] : 0;
  a53=(a53*a60);
  a65=(a65-a53);
  a53=arg[10]? arg[10][3] : 0;
  a53=(a53*a45);
  a65=(a65-a53);
  a53=(a26*a28);
  a53=(a01*a53);
  a52=(a58*a23);
  a56=(a53-a52);
  a56=(a65*a56);
  a64=(a64+a56);
  a56=arg[9]? arg[9][0] : 0;
  a56=(a11-a56);
  a60=(a60*a56);
  a20=(a20-a57);
  a20=(a20+a55);
  a20=(a20-a59);
  a47=(a47*a20);
  a60=(a60-a47);
  a48=(a48+a17);
  a51=(a51*a48);
  a60=(a60-a51);
  a50=(a50-a49);
  a54=(a54*a50);
  a60=(a60-a54);
  a54=arg[10]? arg[10][0] : 0;
  a54=(a54*a61);
  a60=(a60-a54);
  a54=arg[10]? arg[10][1] : 0;
  a54=(a54*a45);
  a60=(a60-a54);
  a54=(a26*a26);
  a45=(a28*a28);
  a61=(a54-a45);
  a12=(a12*a12);
  a50=(a23*a23);
  a49=(a12-a50);
  a61=(a61+a49);
  a61=(a60*a61);
  a64=(a64+a61);
  a61=arg[1]? arg[1][1] : 0;
  a51=arg[0]? arg[0][2] : 0;
  a48=6378137.;
  a17=6.6943799901413173e-03;
  a47=arg[0]? arg[0][0] : 0;
  a20=sin(a47);
  a59=(a20*a20);
  a17=(a17*a59);
  a11=(a11-a17);
  a17=sqrt(a11);
  a48=(a48/a17);
  a48=(a51+a48);
  a61=(a61/a48);
  a64=(a64-a61);
  a48=7.2921149999999999e-05;
  a47=cos(a47);
  a59=(a48*a47);
  a64=(a64-a59);
  a64=(a44*a64);
  a25=(a25-a64);
  a16=(a16*a15);
  a24=(a24*a27);
  a24=(a01*a24);
  a27=(a16+a24);
  a08=(a08*a04);
  a08=(a01*a08);
  a03=(a03*a06);
  a06=(a08-a03);
  a04=(a27*a06);
  a04=(a00*a04);
  a25=(a25-a04);
  a36=(a33+a36);
  a36=(a36-a32);
  a30=(a30+a29);
  a29=(a36*a30);
  a29=(a00*a29);
  a25=(a25+a29);
  a13=(a13-a42);
  a42=(a41-a37);
  a42=(a42+a39);
  a39=(a13*a42);
  a39=(a00*a39);
  a25=(a25-a39);
  if (res[0]!=0) res[0][0]=a25;
  a35=(a35-a33);
  a35=(a35+a14);
  a35=(a35-a32);
  a06=(a06*a35);
  a06=(a00*a06);
  a24=(a24-a16);
  a30=(a30*a24);
  a30=(a00*a30);
  a06=(a06+a30);
  a18=(a18+a21);
  a42=(a42*a18);
  a42=(a00*a42);
  a06=(a06+a42);
  a28=(a28*a23);
  a01=(a01*a28);
  a58=(a58*a26);
  a26=(a01-a58);
  a26=(a46*a26);
  a49=(a45+a49);
  a49=(a49-a54);
  a49=(a65*a49);
  a26=(a26+a49);
  a52=(a52+a53);
  a52=(a60*a52);
  a26=(a26+a52);
  a52=arg[1]? arg[1][0] : 0;
  a53=6.3354393272928204e+06;
  a11=(a11*a17);
  a53=(a53/a11);
  a51=(a51+a53);
  a52=(a52/a51);
  a26=(a26+a52);
  a26=(a44*a26);
  a06=(a06-a26);
  a02=(a02-a37);
  a02=(a02+a38);
  a02=(a02-a41);
  a19=(a19*a02);
  a19=(a00*a19);
  a06=(a06-a19);
  a03=(a03+a08);
  a34=(a34*a03);
  a34=(a00*a34);
  a06=(a06+a34);
  a07=(a07-a05);
  a43=(a43*a07);
  a43=(a00*a43);
  a06=(a06-a43);
  if (res[0]!=0) res[0][1]=a06;
  a27=(a27*a02);
  a27=(a00*a27);
  a36=(a36*a07);
  a36=(a00*a36);
  a27=(a27-a36);
  a13=(a13*a03);
  a13=(a00*a13);
  a27=(a27+a13);
  a48=(a48*a20);
  a12=(a12-a45);
  a12=(a12+a50);
  a12=(a12-a54);
  a46=(a46*a12);
  a48=(a48+a46);
  a20=(a20/a47);
  a61=(a61*a20);
  a48=(a48+a61);
  a58=(a58+a01);
  a65=(a65*a58);
  a48=(a48+a65);
  a63=(a63-a62);
  a60=(a60*a63);
  a48=(a48+a60);
  a44=(a44*a48);
  a27=(a27-a44);
  a09=(a09*a35);
  a09=(a00*a09);
  a27=(a27-a09);
  a31=(a31*a18);
  a31=(a00*a31);
  a27=(a27-a31);
  a40=(a40*a24);
  a00=(a00*a40);
  a27=(a27-a00);
  if (res[0]!=0) res[0][2]=a27;
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


