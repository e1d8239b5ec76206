/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_dcm_H_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vas_dcm_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_dcm_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_dcm_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {6, 1, 1};
static const casadi_int casadi_s3[3] = {24, 1, 1};

/* vas_dcm_H_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],flexure[3],flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_H[24]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58;
  a00=-1.;
  if (res[0]!=0) res[0][0]=a00;
  a01=arg[2]? arg[2][1] : 0;
  a02=arg[3]? arg[3][0] : 0;
  a03=1.;
  a04=2.5000000000000000e-01;
  a05=arg[5]? arg[5][0] : 0;
  a06=(a05*a05);
  a06=(a04*a06);
  a06=(a03+a06);
  a07=arg[5]? arg[5][1] : 0;
  a08=(a07*a07);
  a08=(a04*a08);
  a06=(a06+a08);
  a08=arg[5]? arg[5][2] : 0;
  a09=(a08*a08);
  a04=(a04*a09);
  a06=(a06+a04);
  a06=sqrt(a06);
  a06=(a03/a06);
  a04=(a02*a06);
  a09=arg[3]? arg[3][1] : 0;
  a10=5.0000000000000000e-01;
  a10=(a10*a06);
  a05=(a10*a05);
  a11=(a09*a05);
  a04=(a04-a11);
  a11=arg[3]? arg[3][2] : 0;
  a07=(a10*a07);
  a12=(a11*a07);
  a04=(a04-a12);
  a12=arg[3]? arg[3][3] : 0;
  a10=(a10*a08);
  a08=(a12*a10);
  a04=(a04-a08);
  a08=(a01*a04);
  a13=arg[2]? arg[2][3] : 0;
  a14=(a02*a07);
  a15=(a09*a10);
  a14=(a14+a15);
  a15=(a11*a06);
  a14=(a14+a15);
  a15=(a12*a05);
  a14=(a14-a15);
  a15=(a13*a14);
  a08=(a08+a15);
  a15=arg[2]? arg[2][0] : 0;
  a16=(a02*a05);
  a17=(a09*a06);
  a16=(a16+a17);
  a17=(a12*a07);
  a16=(a16+a17);
  a17=(a11*a10);
  a16=(a16-a17);
  a17=(a15*a16);
  a08=(a08-a17);
  a17=arg[2]? arg[2][2] : 0;
  a10=(a02*a10);
  a05=(a11*a05);
  a10=(a10+a05);
  a06=(a12*a06);
  a10=(a10+a06);
  a07=(a09*a07);
  a10=(a10-a07);
  a07=(a17*a10);
  a08=(a08-a07);
  a07=(a08*a08);
  a06=(a01*a10);
  a05=(a17*a04);
  a06=(a06+a05);
  a05=(a15*a14);
  a06=(a06-a05);
  a05=(a13*a16);
  a06=(a06-a05);
  a05=(a06*a06);
  a18=(a07-a05);
  a19=(a15*a04);
  a20=(a01*a16);
  a19=(a19+a20);
  a20=(a17*a14);
  a19=(a19+a20);
  a20=(a13*a10);
  a19=(a19+a20);
  a20=(a19*a19);
  a16=(a17*a16);
  a04=(a13*a04);
  a16=(a16+a04);
  a10=(a15*a10);
  a16=(a16-a10);
  a14=(a01*a14);
  a16=(a16-a14);
  a14=(a16*a16);
  a10=(a20-a14);
  a04=(a18+a10);
  if (res[0]!=0) res[0][1]=a04;
  a21=2.;
  a22=(a21*a08);
  a23=(a22*a06);
  a19=(a21*a19);
  a24=(a19*a16);
  a25=(a23-a24);
  if (res[0]!=0) res[0][2]=a25;
  a26=(a19*a06);
  a22=(a22*a16);
  a27=(a26+a22);
  if (res[0]!=0) res[0][3]=a27;
  a28=arg[1]? arg[1][1] : 0;
  a29=arg[0]? arg[0][2] : 0;
  a30=6378137.;
  a31=6.6943799901413173e-03;
  a32=arg[0]? arg[0][0] : 0;
  a33=sin(a32);
  a34=(a33*a33);
  a31=(a31*a34);
  a31=(a03-a31);
  a34=sqrt(a31);
  a30=(a30/a34);
  a30=(a29+a30);
  a28=(a28/a30);
  a30=7.2921149999999999e-05;
  a32=cos(a32);
  a35=(a30*a32);
  a35=(a28+a35);
  a36=arg[4]? arg[4][0] : 0;
  a37=arg[7]? arg[7][0] : 0;
  a37=(a03-a37);
  a37=(a36*a37);
  a38=arg[6]? arg[6][0] : 0;
  a39=(a09*a09);
  a40=(a11*a11);
  a41=(a39-a40);
  a42=(a02*a02);
  a43=(a12*a12);
  a44=(a42-a43);
  a41=(a41+a44);
  a41=(a38*a41);
  a37=(a37-a41);
  a41=arg[6]? arg[6][1] : 0;
  a02=(a21*a02);
  a45=(a02*a12);
  a46=(a21*a09);
  a47=(a46*a11);
  a48=(a45+a47);
  a48=(a41*a48);
  a37=(a37-a48);
  a48=arg[6]? arg[6][2] : 0;
  a46=(a46*a12);
  a49=(a02*a11);
  a50=(a46-a49);
  a50=(a48*a50);
  a37=(a37-a50);
  a50=arg[8]? arg[8][0] : 0;
  a51=arg[4]? arg[4][1] : 0;
  a50=(a50*a51);
  a37=(a37-a50);
  a50=arg[8]? arg[8][1] : 0;
  a52=arg[4]? arg[4][2] : 0;
  a50=(a50*a52);
  a37=(a37-a50);
  a50=(a01*a01);
  a53=(a17*a17);
  a54=(a50-a53);
  a55=(a15*a15);
  a56=(a13*a13);
  a57=(a55-a56);
  a54=(a54+a57);
  a54=(a37*a54);
  a58=arg[7]? arg[7][1] : 0;
  a58=(a03-a58);
  a58=(a51*a58);
  a47=(a47-a45);
  a47=(a38*a47);
  a58=(a58-a47);
  a44=(a40+a44);
  a44=(a44-a39);
  a44=(a41*a44);
  a58=(a58-a44);
  a02=(a02*a09);
  a11=(a21*a11);
  a11=(a11*a12);
  a12=(a02+a11);
  a12=(a48*a12);
  a58=(a58-a12);
  a12=arg[8]? arg[8][2] : 0;
  a12=(a12*a36);
  a58=(a58-a12);
  a12=arg[8]? arg[8][3] : 0;
  a12=(a12*a52);
  a58=(a58-a12);
  a12=(a21*a01);
  a09=(a12*a17);
  a15=(a21*a15);
  a44=(a15*a13);
  a47=(a09-a44);
  a47=(a58*a47);
  a54=(a54+a47);
  a47=arg[7]? arg[7][2] : 0;
  a03=(a03-a47);
  a52=(a52*a03);
  a49=(a49+a46);
  a38=(a38*a49);
  a52=(a52-a38);
  a11=(a11-a02);
  a41=(a41*a11);
  a52=(a52-a41);
  a42=(a42-a40);
  a42=(a42+a43);
  a42=(a42-a39);
  a48=(a48*a42);
  a52=(a52-a48);
  a48=arg[8]? arg[8][4] : 0;
  a48=(a48*a36);
  a52=(a52-a48);
  a48=arg[8]? arg[8][5] : 0;
  a48=(a48*a51);
  a52=(a52-a48);
  a48=(a15*a17);
  a12=(a12*a13);
  a51=(a48+a12);
  a51=(a52*a51);
  a54=(a54+a51);
  a35=(a35-a54);
  if (res[0]!=0) res[0][4]=a35;
  a04=(-a04);
  if (res[0]!=0) res[0][5]=a04;
  a25=(-a25);
  if (res[0]!=0) res[0][6]=a25;
  a27=(-a27);
  if (res[0]!=0) res[0][7]=a27;
  if (res[0]!=0) res[0][8]=a00;
  a24=(a24+a23);
  if (res[0]!=0) res[0][9]=a24;
  a10=(a10-a18);
  if (res[0]!=0) res[0][10]=a10;
  a06=(a21*a06);
  a06=(a06*a16);
  a19=(a19*a08);
  a08=(a06-a19);
  if (res[0]!=0) res[0][11]=a08;
  a44=(a44+a09);
  a44=(a37*a44);
  a57=(a53+a57);
  a57=(a57-a50);
  a57=(a58*a57);
  a44=(a44+a57);
  a21=(a21*a17);
  a21=(a21*a13);
  a15=(a15*a01);
  a01=(a21-a15);
  a01=(a52*a01);
  a44=(a44+a01);
  a01=arg[1]? arg[1][0] : 0;
  a13=6.3354393272928204e+06;
  a31=(a31*a34);
  a13=(a13/a31);
  a29=(a29+a13);
  a01=(a01/a29);
  a44=(a44+a01);
  a44=(-a44);
  if (res[0]!=0) res[0][12]=a44;
  a24=(-a24);
  if (res[0]!=0) res[0][13]=a24;
  a10=(-a10);
  if (res[0]!=0) res[0][14]=a10;
  a08=(-a08);
  if (res[0]!=0) res[0][15]=a08;
  if (res[0]!=0) res[0][16]=a00;
  a22=(a22-a26);
  if (res[0]!=0) res[0][17]=a22;
  a19=(a19+a06);
  if (res[0]!=0) res[0][18]=a19;
  a07=(a07+a05);
  a20=(a20-a07);
  a20=(a20+a14);
  if (res[0]!=0) res[0][19]=a20;
  a12=(a12-a48);
  a37=(a37*a12);
  a15=(a15+a21);
  a58=(a58*a15);
  a37=(a37+a58);
  a55=(a55-a53);
  a55=(a55+a56);
  a55=(a55-a50);
  a52=(a52*a55);
  a37=(a37+a52);
  a32=(a33/a32);
  a28=(a28*a32);
  a30=(a30*a33);
  a28=(a28+a30);
  a37=(a37+a28);
  a37=(-a37);
  if (res[0]!=0) res[0][20]=a37;
  a22=(-a22);
  if (res[0]!=0) res[0][21]=a22;
  a19=(-a19);
  if (res[0]!=0) res[0][22]=a19;
  a20=(-a20);
  if (res[0]!=0) res[0][23]=a20;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_dcm_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_dcm_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_dcm_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_dcm_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_dcm_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_dcm_H_casadi_n_in(void) { return 9;}

CASADI_SYMBOL_EXPORT casadi_int vas_dcm_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_dcm_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_dcm_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "flexure";
    case 6: return "flexure_rate";
    case 7: return "gyro_scale";
    case 8: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_dcm_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_dcm_H_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s0;
    case 7: return casadi_s0;
    case 8: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_dcm_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_dcm_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_dcm_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


