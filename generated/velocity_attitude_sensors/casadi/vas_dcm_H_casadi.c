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
  casadi_real a48, a49, a50, a51, a52, a53, a54;
  a00=-1.;
  if (res[0]!=0) res[0][0]=a00;
  a01=arg[3]? arg[3][2] : 0;
  a02=1.;
  a03=2.5000000000000000e-01;
  a04=arg[5]? arg[5][0] : 0;
  a05=(a04*a04);
  a05=(a03*a05);
  a05=(a02+a05);
  a06=arg[5]? arg[5][1] : 0;
  a07=(a06*a06);
  a07=(a03*a07);
  a05=(a05+a07);
  a07=arg[5]? arg[5][2] : 0;
  a08=(a07*a07);
  a03=(a03*a08);
  a05=(a05+a03);
  a05=sqrt(a05);
  a05=(a02/a05);
  a03=(a01*a05);
  a08=arg[3]? arg[3][1] : 0;
  a09=(a08*a05);
  a10=5.0000000000000000e-01;
  a07=(a10*a07);
  a11=(a09*a07);
  a11=(a03+a11);
  a06=(a10*a06);
  a12=arg[3]? arg[3][0] : 0;
  a13=(a12*a05);
  a14=(a06*a13);
  a11=(a11+a14);
  a10=(a10*a04);
  a04=arg[3]? arg[3][3] : 0;
  a05=(a04*a05);
  a14=(a10*a05);
  a11=(a11-a14);
  a14=arg[2]? arg[2][2] : 0;
  a15=(a11*a14);
  a16=(a10*a03);
  a16=(a05+a16);
  a17=(a07*a13);
  a16=(a16+a17);
  a17=(a09*a06);
  a16=(a16-a17);
  a17=arg[2]? arg[2][3] : 0;
  a18=(a16*a17);
  a15=(a15+a18);
  a18=(a09*a10);
  a18=(a13-a18);
  a19=(a03*a06);
  a18=(a18-a19);
  a19=(a05*a07);
  a18=(a18-a19);
  a19=arg[2]? arg[2][0] : 0;
  a20=(a18*a19);
  a15=(a15+a20);
  a10=(a10*a13);
  a09=(a09+a10);
  a06=(a06*a05);
  a09=(a09+a06);
  a03=(a03*a07);
  a09=(a09-a03);
  a03=arg[2]? arg[2][1] : 0;
  a07=(a09*a03);
  a15=(a15+a07);
  a07=(a15*a15);
  a06=(a18*a17);
  a05=(a09*a14);
  a06=(a06+a05);
  a05=(a11*a03);
  a06=(a06-a05);
  a05=(a16*a19);
  a06=(a06-a05);
  a05=(a06*a06);
  a10=(a07-a05);
  a13=(a11*a17);
  a20=(a18*a03);
  a13=(a13+a20);
  a20=(a16*a14);
  a13=(a13-a20);
  a20=(a09*a19);
  a13=(a13-a20);
  a20=(a13*a13);
  a16=(a16*a03);
  a18=(a18*a14);
  a16=(a16+a18);
  a11=(a11*a19);
  a16=(a16-a11);
  a09=(a09*a17);
  a16=(a16-a09);
  a09=(a16*a16);
  a11=(a20-a09);
  a10=(a10+a11);
  if (res[0]!=0) res[0][1]=a10;
  a18=2.;
  a21=(a18*a13);
  a22=(a16*a21);
  a15=(a18*a15);
  a23=(a06*a15);
  a24=(a22-a23);
  if (res[0]!=0) res[0][2]=a24;
  a25=(a16*a15);
  a21=(a06*a21);
  a26=(a25+a21);
  if (res[0]!=0) res[0][3]=a26;
  a27=7.2921149999999999e-05;
  a28=arg[0]? arg[0][0] : 0;
  a29=cos(a28);
  a30=(a27*a29);
  a31=arg[1]? arg[1][1] : 0;
  a32=arg[0]? arg[0][2] : 0;
  a33=6378137.;
  a34=6.6943799901413173e-03;
  a28=sin(a28);
  a35=(a28*a28);
  a34=(a34*a35);
  a34=(a02-a34);
  a35=sqrt(a34);
  a33=(a33/a35);
  a33=(a32+a33);
  a31=(a31/a33);
  a30=(a30+a31);
  a33=arg[4]? arg[4][2] : 0;
  a36=arg[7]? arg[7][2] : 0;
  a36=(a02-a36);
  a36=(a33*a36);
  a37=arg[6]? arg[6][0] : 0;
  a38=(a18*a12);
  a39=(a38*a01);
  a40=(a08*a04);
  a40=(a18*a40);
  a41=(a39+a40);
  a41=(a37*a41);
  a36=(a36-a41);
  a41=arg[6]? arg[6][1] : 0;
  a42=(a01*a04);
  a42=(a18*a42);
  a43=(a38*a08);
  a44=(a42-a43);
  a44=(a41*a44);
  a36=(a36-a44);
  a44=arg[6]? arg[6][2] : 0;
  a45=(a04*a04);
  a46=(a01*a01);
  a47=(a45-a46);
  a12=(a12*a12);
  a48=(a08*a08);
  a49=(a12-a48);
  a47=(a47+a49);
  a47=(a44*a47);
  a36=(a36-a47);
  a47=arg[8]? arg[8][4] : 0;
  a50=arg[4]? arg[4][0] : 0;
  a47=(a47*a50);
  a36=(a36-a47);
  a47=arg[8]? arg[8][5] : 0;
  a51=arg[4]? arg[4][1] : 0;
  a47=(a47*a51);
  a36=(a36-a47);
  a47=(a18*a19);
  a52=(a47*a14);
  a53=(a18*a03);
  a53=(a53*a17);
  a54=(a52+a53);
  a54=(a36*a54);
  a30=(a30-a54);
  a54=arg[7]? arg[7][1] : 0;
  a54=(a02-a54);
  a54=(a51*a54);
  a08=(a08*a01);
  a08=(a18*a08);
  a38=(a38*a04);
  a04=(a08-a38);
  a04=(a37*a04);
  a54=(a54-a04);
  a49=(a46+a49);
  a49=(a49-a45);
  a49=(a41*a49);
  a54=(a54-a49);
  a43=(a43+a42);
  a43=(a44*a43);
  a54=(a54-a43);
  a43=arg[8]? arg[8][2] : 0;
  a43=(a43*a50);
  a54=(a54-a43);
  a43=arg[8]? arg[8][3] : 0;
  a43=(a43*a33);
  a54=(a54-a43);
  a43=(a03*a14);
  a43=(a18*a43);
  a42=(a47*a17);
  a49=(a43-a42);
  a49=(a54*a49);
  a30=(a30-a49);
  a49=arg[7]? arg[7][0] : 0;
  a02=(a02-a49);
  a50=(a50*a02);
  a12=(a12-a46);
  a12=(a12+a48);
  a12=(a12-a45);
  a37=(a37*a12);
  a50=(a50-a37);
  a38=(a38+a08);
  a41=(a41*a38);
  a50=(a50-a41);
  a40=(a40-a39);
  a44=(a44*a40);
  a50=(a50-a44);
  a44=arg[8]? arg[8][0] : 0;
  a44=(a44*a51);
  a50=(a50-a44);
  a44=arg[8]? arg[8][1] : 0;
  a44=(a44*a33);
  a50=(a50-a44);
  a44=(a03*a03);
  a33=(a14*a14);
  a51=(a44-a33);
  a19=(a19*a19);
  a40=(a17*a17);
  a39=(a19-a40);
  a51=(a51+a39);
  a51=(a50*a51);
  a30=(a30-a51);
  if (res[0]!=0) res[0][4]=a30;
  a10=(-a10);
  if (res[0]!=0) res[0][5]=a10;
  a24=(-a24);
  if (res[0]!=0) res[0][6]=a24;
  a26=(-a26);
  if (res[0]!=0) res[0][7]=a26;
  if (res[0]!=0) res[0][8]=a00;
  a23=(a23+a22);
  if (res[0]!=0) res[0][9]=a23;
  a11=(a05+a11);
  a11=(a11-a07);
  a22=(-a11);
  if (res[0]!=0) res[0][10]=a22;
  a13=(a13*a15);
  a06=(a06*a16);
  a06=(a18*a06);
  a16=(a13-a06);
  a15=(-a16);
  if (res[0]!=0) res[0][11]=a15;
  a14=(a14*a17);
  a18=(a18*a14);
  a47=(a47*a03);
  a03=(a18-a47);
  a03=(a36*a03);
  a39=(a33+a39);
  a39=(a39-a44);
  a39=(a54*a39);
  a03=(a03+a39);
  a42=(a42+a43);
  a42=(a50*a42);
  a03=(a03+a42);
  a42=arg[1]? arg[1][0] : 0;
  a43=6.3354393272928204e+06;
  a34=(a34*a35);
  a43=(a43/a34);
  a32=(a32+a43);
  a42=(a42/a32);
  a03=(a03+a42);
  a03=(-a03);
  if (res[0]!=0) res[0][12]=a03;
  a23=(-a23);
  if (res[0]!=0) res[0][13]=a23;
  if (res[0]!=0) res[0][14]=a11;
  if (res[0]!=0) res[0][15]=a16;
  if (res[0]!=0) res[0][16]=a00;
  a21=(a21-a25);
  if (res[0]!=0) res[0][17]=a21;
  a13=(a13+a06);
  if (res[0]!=0) res[0][18]=a13;
  a20=(a20-a05);
  a20=(a20+a09);
  a20=(a20-a07);
  a07=(-a20);
  if (res[0]!=0) res[0][19]=a07;
  a27=(a27*a28);
  a19=(a19-a33);
  a19=(a19+a40);
  a19=(a19-a44);
  a36=(a36*a19);
  a27=(a27+a36);
  a47=(a47+a18);
  a54=(a54*a47);
  a27=(a27+a54);
  a53=(a53-a52);
  a50=(a50*a53);
  a27=(a27+a50);
  a28=(a28/a29);
  a31=(a31*a28);
  a27=(a27+a31);
  a27=(-a27);
  if (res[0]!=0) res[0][20]=a27;
  a21=(-a21);
  if (res[0]!=0) res[0][21]=a21;
  a13=(-a13);
  if (res[0]!=0) res[0][22]=a13;
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


