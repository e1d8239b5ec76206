/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_euler_H_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vas_euler_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_euler_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_euler_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {6, 1, 1};
static const casadi_int casadi_s3[3] = {24, 1, 1};

/* vas_euler_H_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],euler_m[3],flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_H[24]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53;
  a00=arg[5]? arg[5][1] : 0;
  a01=sin(a00);
  a02=arg[5]? arg[5][0] : 0;
  a03=sin(a02);
  a04=1.;
  a00=cos(a00);
  a05=(a04/a00);
  a06=(a03*a05);
  a07=arg[5]? arg[5][2] : 0;
  a08=cos(a07);
  a09=(a03*a08);
  a10=(a01*a09);
  a07=sin(a07);
  a02=cos(a02);
  a11=(a07*a02);
  a10=(a10-a11);
  a12=(a06*a10);
  a13=(a01*a12);
  a05=(a02*a05);
  a14=(a03*a07);
  a15=(a08*a02);
  a16=(a01*a15);
  a16=(a14+a16);
  a17=(a05*a16);
  a18=(a01*a17);
  a13=(a13+a18);
  a18=(a00*a08);
  a13=(a13+a18);
  a18=(-a13);
  if (res[0]!=0) res[0][0]=a18;
  a14=(a01*a14);
  a15=(a15+a14);
  a14=(a06*a15);
  a18=(a01*a14);
  a11=(a01*a11);
  a11=(a11-a09);
  a09=(a05*a11);
  a01=(a01*a09);
  a18=(a18+a01);
  a00=(a00*a07);
  a18=(a18+a00);
  a00=(-a18);
  if (res[0]!=0) res[0][1]=a00;
  if (res[0]!=0) res[0][2]=a04;
  a15=(a18*a15);
  a10=(a13*a10);
  a15=(a15+a10);
  if (res[0]!=0) res[0][3]=a15;
  a11=(a18*a11);
  a16=(a13*a16);
  a11=(a11+a16);
  if (res[0]!=0) res[0][4]=a11;
  a16=arg[1]? arg[1][1] : 0;
  a10=arg[0]? arg[0][2] : 0;
  a00=6378137.;
  a01=6.6943799901413173e-03;
  a19=arg[0]? arg[0][0] : 0;
  a20=sin(a19);
  a21=(a20*a20);
  a01=(a01*a21);
  a01=(a04-a01);
  a21=sqrt(a01);
  a00=(a00/a21);
  a00=(a10+a00);
  a16=(a16/a00);
  a00=7.2921149999999999e-05;
  a19=cos(a19);
  a22=(a00*a19);
  a22=(a16+a22);
  a23=arg[4]? arg[4][0] : 0;
  a24=arg[7]? arg[7][0] : 0;
  a24=(a04-a24);
  a24=(a23*a24);
  a25=arg[6]? arg[6][0] : 0;
  a26=arg[3]? arg[3][1] : 0;
  a27=(a26*a26);
  a28=arg[3]? arg[3][2] : 0;
  a29=(a28*a28);
  a30=(a27-a29);
  a31=arg[3]? arg[3][0] : 0;
  a32=(a31*a31);
  a33=arg[3]? arg[3][3] : 0;
  a34=(a33*a33);
  a35=(a32-a34);
  a30=(a30+a35);
  a30=(a25*a30);
  a24=(a24-a30);
  a30=arg[6]? arg[6][1] : 0;
  a36=2.;
  a31=(a36*a31);
  a37=(a31*a33);
  a38=(a36*a26);
  a39=(a38*a28);
  a40=(a37+a39);
  a40=(a30*a40);
  a24=(a24-a40);
  a40=arg[6]? arg[6][2] : 0;
  a38=(a38*a33);
  a41=(a31*a28);
  a42=(a38-a41);
  a42=(a40*a42);
  a24=(a24-a42);
  a42=arg[8]? arg[8][0] : 0;
  a43=arg[4]? arg[4][1] : 0;
  a42=(a42*a43);
  a24=(a24-a42);
  a42=arg[8]? arg[8][1] : 0;
  a44=arg[4]? arg[4][2] : 0;
  a42=(a42*a44);
  a24=(a24-a42);
  a42=arg[2]? arg[2][1] : 0;
  a45=(a42*a42);
  a46=arg[2]? arg[2][2] : 0;
  a47=(a46*a46);
  a48=(a45-a47);
  a49=arg[2]? arg[2][0] : 0;
  a50=(a49*a49);
  a51=arg[2]? arg[2][3] : 0;
  a52=(a51*a51);
  a53=(a50-a52);
  a48=(a48+a53);
  a48=(a24*a48);
  a22=(a22-a48);
  a48=arg[7]? arg[7][1] : 0;
  a48=(a04-a48);
  a48=(a43*a48);
  a39=(a39-a37);
  a39=(a25*a39);
  a48=(a48-a39);
  a35=(a29+a35);
  a35=(a35-a27);
  a35=(a30*a35);
  a48=(a48-a35);
  a31=(a31*a26);
  a28=(a36*a28);
  a28=(a28*a33);
  a33=(a31+a28);
  a33=(a40*a33);
  a48=(a48-a33);
  a33=arg[8]? arg[8][2] : 0;
  a33=(a33*a23);
  a48=(a48-a33);
  a33=arg[8]? arg[8][3] : 0;
  a33=(a33*a44);
  a48=(a48-a33);
  a33=(a36*a42);
  a26=(a33*a46);
  a49=(a36*a49);
  a35=(a49*a51);
  a39=(a26-a35);
  a39=(a48*a39);
  a22=(a22-a39);
  a39=arg[7]? arg[7][2] : 0;
  a04=(a04-a39);
  a44=(a44*a04);
  a41=(a41+a38);
  a25=(a25*a41);
  a44=(a44-a25);
  a28=(a28-a31);
  a30=(a30*a28);
  a44=(a44-a30);
  a32=(a32-a29);
  a32=(a32+a34);
  a32=(a32-a27);
  a40=(a40*a32);
  a44=(a44-a40);
  a40=arg[8]? arg[8][4] : 0;
  a40=(a40*a23);
  a44=(a44-a40);
  a40=arg[8]? arg[8][5] : 0;
  a40=(a40*a43);
  a44=(a44-a40);
  a40=(a49*a46);
  a33=(a33*a51);
  a43=(a40+a33);
  a43=(a44*a43);
  a22=(a22-a43);
  a13=(a13*a22);
  a43=arg[1]? arg[1][0] : 0;
  a23=6.3354393272928204e+06;
  a01=(a01*a21);
  a23=(a23/a01);
  a10=(a10+a23);
  a43=(a43/a10);
  a35=(a35+a26);
  a35=(a24*a35);
  a43=(a43+a35);
  a53=(a47+a53);
  a53=(a53-a45);
  a53=(a48*a53);
  a43=(a43+a53);
  a36=(a36*a46);
  a36=(a36*a51);
  a49=(a49*a42);
  a42=(a36-a49);
  a42=(a44*a42);
  a43=(a43+a42);
  a18=(a18*a43);
  a13=(a13-a18);
  if (res[0]!=0) res[0][5]=a13;
  a13=-1.;
  if (res[0]!=0) res[0][6]=a13;
  a15=(-a15);
  if (res[0]!=0) res[0][7]=a15;
  a11=(-a11);
  if (res[0]!=0) res[0][8]=a11;
  if (res[0]!=0) res[0][9]=a07;
  a11=(-a08);
  if (res[0]!=0) res[0][10]=a11;
  if (res[0]!=0) res[0][11]=a02;
  a11=(-a03);
  if (res[0]!=0) res[0][12]=a11;
  a07=(a07*a22);
  a08=(a08*a43);
  a07=(a07+a08);
  a07=(-a07);
  if (res[0]!=0) res[0][13]=a07;
  a02=(-a02);
  if (res[0]!=0) res[0][14]=a02;
  if (res[0]!=0) res[0][15]=a03;
  a12=(a12+a17);
  a17=(-a12);
  if (res[0]!=0) res[0][16]=a17;
  a14=(a14+a09);
  a09=(-a14);
  if (res[0]!=0) res[0][17]=a09;
  if (res[0]!=0) res[0][18]=a13;
  if (res[0]!=0) res[0][19]=a06;
  if (res[0]!=0) res[0][20]=a05;
  a12=(a12*a22);
  a14=(a14*a43);
  a12=(a12-a14);
  a19=(a20/a19);
  a16=(a16*a19);
  a00=(a00*a20);
  a16=(a16+a00);
  a33=(a33-a40);
  a24=(a24*a33);
  a16=(a16+a24);
  a49=(a49+a36);
  a48=(a48*a49);
  a16=(a16+a48);
  a50=(a50-a47);
  a50=(a50+a52);
  a50=(a50-a45);
  a44=(a44*a50);
  a16=(a16+a44);
  a12=(a12-a16);
  if (res[0]!=0) res[0][21]=a12;
  a06=(-a06);
  if (res[0]!=0) res[0][22]=a06;
  a05=(-a05);
  if (res[0]!=0) res[0][23]=a05;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_euler_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_euler_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_euler_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_euler_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_euler_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_euler_H_casadi_n_in(void) { return 9;}

CASADI_SYMBOL_EXPORT casadi_int vas_euler_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_euler_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_euler_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "euler_m";
    case 6: return "flexure_rate";
    case 7: return "gyro_scale";
    case 8: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_euler_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_euler_H_casadi_sparsity_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const casadi_int* vas_euler_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_euler_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_euler_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


