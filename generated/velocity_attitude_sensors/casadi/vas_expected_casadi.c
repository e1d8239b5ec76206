/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_expected_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vas_expected_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_expected_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_expected_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {6, 1, 1};

/* vas_expected_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],lever_b[3],flexure[3],flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_v_m_n[3],out_q_m2n_wxyz[4],out_omega_nb_n[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=7.2921149999999999e-05;
  a03=arg[0]? arg[0][0] : 0;
  a04=sin(a03);
  a05=(a02*a04);
  a06=arg[1]? arg[1][1] : 0;
  a07=arg[0]? arg[0][2] : 0;
  a08=6378137.;
  a09=1.;
  a10=6.6943799901413173e-03;
  a11=(a04*a04);
  a10=(a10*a11);
  a10=(a09-a10);
  a11=sqrt(a10);
  a08=(a08/a11);
  a08=(a07+a08);
  a08=(a06/a08);
  a03=cos(a03);
  a04=(a04/a03);
  a04=(a08*a04);
  a05=(a05+a04);
  a04=2.;
  a12=arg[2]? arg[2][0] : 0;
  a13=(a04*a12);
  a14=arg[2]? arg[2][3] : 0;
  a15=(a13*a14);
  a16=arg[2]? arg[2][1] : 0;
  a17=(a04*a16);
  a18=arg[2]? arg[2][2] : 0;
  a17=(a17*a18);
  a19=(a15+a17);
  a20=(a05*a19);
  a21=(a16*a14);
  a21=(a04*a21);
  a22=(a13*a18);
  a23=(a21-a22);
  a24=6.3354393272928204e+06;
  a10=(a10*a11);
  a24=(a24/a10);
  a07=(a07+a24);
  a07=(a00/a07);
  a24=(a23*a07);
  a20=(a20-a24);
  a20=(a01*a20);
  a00=(a00+a20);
  a20=arg[5]? arg[5][1] : 0;
  a24=(a18*a18);
  a10=(a14*a14);
  a11=(a24-a10);
  a25=(a12*a12);
  a26=(a16*a16);
  a27=(a25-a26);
  a11=(a11+a27);
  a28=(a05*a11);
  a13=(a13*a16);
  a29=(a18*a14);
  a29=(a04*a29);
  a30=(a13+a29);
  a31=(a30*a07);
  a28=(a28-a31);
  a28=(a20*a28);
  a00=(a00+a28);
  a28=arg[5]? arg[5][2] : 0;
  a29=(a29-a13);
  a13=(a05*a29);
  a27=(a10+a27);
  a27=(a27-a24);
  a31=(a27*a07);
  a13=(a13-a31);
  a13=(a28*a13);
  a00=(a00+a13);
  a17=(a17-a15);
  a15=arg[4]? arg[4][2] : 0;
  a13=arg[8]? arg[8][2] : 0;
  a13=(a09-a13);
  a13=(a15*a13);
  a31=arg[7]? arg[7][0] : 0;
  a32=arg[3]? arg[3][0] : 0;
  a33=(a04*a32);
  a34=arg[3]? arg[3][2] : 0;
  a35=(a33*a34);
  a36=arg[3]? arg[3][3] : 0;
  a37=(a04*a36);
  a38=arg[3]? arg[3][1] : 0;
  a37=(a37*a38);
  a39=(a35+a37);
  a39=(a31*a39);
  a13=(a13-a39);
  a39=arg[7]? arg[7][1] : 0;
  a40=(a34*a36);
  a40=(a04*a40);
  a41=(a33*a38);
  a42=(a40-a41);
  a42=(a39*a42);
  a13=(a13-a42);
  a42=arg[7]? arg[7][2] : 0;
  a43=(a36*a36);
  a44=(a32*a32);
  a45=(a38*a38);
  a46=(a44-a45);
  a47=(a43+a46);
  a48=(a34*a34);
  a47=(a47-a48);
  a47=(a42*a47);
  a13=(a13-a47);
  a47=arg[9]? arg[9][4] : 0;
  a49=arg[4]? arg[4][0] : 0;
  a47=(a47*a49);
  a13=(a13-a47);
  a47=arg[9]? arg[9][5] : 0;
  a50=arg[4]? arg[4][1] : 0;
  a47=(a47*a50);
  a13=(a13-a47);
  a47=(a17*a13);
  a22=(a22+a21);
  a21=arg[8]? arg[8][1] : 0;
  a21=(a09-a21);
  a21=(a50*a21);
  a51=(a38*a34);
  a04=(a04*a51);
  a33=(a33*a36);
  a51=(a04-a33);
  a51=(a31*a51);
  a21=(a21-a51);
  a51=(a48-a43);
  a51=(a51+a46);
  a51=(a39*a51);
  a21=(a21-a51);
  a41=(a41+a40);
  a41=(a42*a41);
  a21=(a21-a41);
  a41=arg[9]? arg[9][2] : 0;
  a41=(a41*a49);
  a21=(a21-a41);
  a41=arg[9]? arg[9][3] : 0;
  a41=(a41*a15);
  a21=(a21-a41);
  a41=(a22*a21);
  a47=(a47-a41);
  a47=(a01*a47);
  a00=(a00-a47);
  a47=arg[8]? arg[8][0] : 0;
  a47=(a09-a47);
  a49=(a49*a47);
  a44=(a44-a43);
  a44=(a44+a45);
  a44=(a44-a48);
  a31=(a31*a44);
  a49=(a49-a31);
  a33=(a33+a04);
  a39=(a39*a33);
  a49=(a49-a39);
  a37=(a37-a35);
  a42=(a42*a37);
  a49=(a49-a42);
  a42=arg[9]? arg[9][0] : 0;
  a42=(a42*a50);
  a49=(a49-a42);
  a42=arg[9]? arg[9][1] : 0;
  a42=(a42*a15);
  a49=(a49-a42);
  a42=(a22*a49);
  a25=(a25-a10);
  a25=(a25+a26);
  a25=(a25-a24);
  a24=(a13*a25);
  a42=(a42-a24);
  a42=(a20*a42);
  a00=(a00-a42);
  a42=(a21*a25);
  a24=(a17*a49);
  a42=(a42-a24);
  a42=(a28*a42);
  a00=(a00-a42);
  if (res[0]!=0) res[0][0]=a00;
  a02=(a02*a03);
  a03=(a02+a08);
  a00=(a23*a03);
  a42=(a25*a05);
  a00=(a00+a42);
  a00=(a01*a00);
  a06=(a06-a00);
  a00=(a30*a03);
  a42=(a17*a05);
  a00=(a00+a42);
  a00=(a20*a00);
  a06=(a06-a00);
  a00=(a27*a03);
  a42=(a22*a05);
  a00=(a00+a42);
  a00=(a28*a00);
  a06=(a06-a00);
  a00=(a11*a13);
  a42=(a29*a21);
  a00=(a00-a42);
  a00=(a01*a00);
  a06=(a06-a00);
  a00=(a29*a49);
  a42=(a13*a19);
  a00=(a00-a42);
  a00=(a20*a00);
  a06=(a06-a00);
  a00=(a21*a19);
  a42=(a11*a49);
  a00=(a00-a42);
  a00=(a28*a00);
  a06=(a06-a00);
  if (res[0]!=0) res[0][1]=a06;
  a06=arg[1]? arg[1][2] : 0;
  a00=(a25*a07);
  a42=(a03*a19);
  a00=(a00+a42);
  a00=(a01*a00);
  a06=(a06+a00);
  a00=(a11*a03);
  a42=(a17*a07);
  a00=(a00+a42);
  a00=(a20*a00);
  a06=(a06+a00);
  a03=(a29*a03);
  a00=(a22*a07);
  a03=(a03+a00);
  a03=(a28*a03);
  a06=(a06+a03);
  a03=(a30*a13);
  a00=(a27*a21);
  a03=(a03-a00);
  a01=(a01*a03);
  a06=(a06-a01);
  a01=(a27*a49);
  a03=(a23*a13);
  a01=(a01-a03);
  a20=(a20*a01);
  a06=(a06-a20);
  a20=(a23*a21);
  a01=(a30*a49);
  a20=(a20-a01);
  a28=(a28*a20);
  a06=(a06-a28);
  if (res[0]!=0) res[0][2]=a06;
  a06=2.5000000000000000e-01;
  a28=arg[6]? arg[6][0] : 0;
  a20=(a28*a28);
  a20=(a06*a20);
  a20=(a09+a20);
  a01=arg[6]? arg[6][1] : 0;
  a03=(a01*a01);
  a03=(a06*a03);
  a20=(a20+a03);
  a03=arg[6]? arg[6][2] : 0;
  a00=(a03*a03);
  a06=(a06*a00);
  a20=(a20+a06);
  a20=sqrt(a20);
  a20=(a09/a20);
  a32=(a32*a20);
  a38=(a38*a20);
  a06=5.0000000000000000e-01;
  a28=(a06*a28);
  a00=(a38*a28);
  a00=(a32-a00);
  a34=(a34*a20);
  a01=(a06*a01);
  a42=(a34*a01);
  a00=(a00-a42);
  a36=(a36*a20);
  a06=(a06*a03);
  a03=(a36*a06);
  a00=(a00-a03);
  a03=(a00*a12);
  a20=(a28*a32);
  a20=(a38+a20);
  a42=(a01*a36);
  a20=(a20+a42);
  a42=(a34*a06);
  a20=(a20-a42);
  a42=(a20*a16);
  a03=(a03+a42);
  a42=(a38*a06);
  a42=(a34+a42);
  a24=(a01*a32);
  a42=(a42+a24);
  a24=(a28*a36);
  a42=(a42-a24);
  a24=(a42*a18);
  a03=(a03+a24);
  a28=(a28*a34);
  a36=(a36+a28);
  a06=(a06*a32);
  a36=(a36+a06);
  a38=(a38*a01);
  a36=(a36-a38);
  a38=(a36*a14);
  a03=(a03+a38);
  a38=(a03*a03);
  a01=(a00*a16);
  a06=(a42*a14);
  a01=(a01+a06);
  a06=(a20*a12);
  a01=(a01-a06);
  a06=(a36*a18);
  a01=(a01-a06);
  a06=(a01*a01);
  a38=(a38+a06);
  a06=(a00*a14);
  a32=(a20*a18);
  a06=(a06+a32);
  a32=(a42*a16);
  a06=(a06-a32);
  a32=(a36*a12);
  a06=(a06-a32);
  a32=(a06*a06);
  a38=(a38+a32);
  a00=(a00*a18);
  a36=(a36*a16);
  a00=(a00+a36);
  a20=(a20*a14);
  a00=(a00-a20);
  a42=(a42*a12);
  a00=(a00-a42);
  a42=(a00*a00);
  a38=(a38+a42);
  a38=sqrt(a38);
  a09=(a09/a38);
  a03=(a03*a09);
  if (res[1]!=0) res[1][0]=a03;
  a01=(a01*a09);
  if (res[1]!=0) res[1][1]=a01;
  a00=(a00*a09);
  if (res[1]!=0) res[1][2]=a00;
  a06=(a06*a09);
  if (res[1]!=0) res[1][3]=a06;
  a22=(a22*a13);
  a17=(a21*a17);
  a22=(a22+a17);
  a25=(a49*a25);
  a22=(a22+a25);
  a22=(a22-a02);
  a22=(a22-a08);
  if (res[2]!=0) res[2][0]=a22;
  a11=(a11*a21);
  a07=(a07+a11);
  a29=(a29*a13);
  a07=(a07+a29);
  a19=(a49*a19);
  a07=(a07+a19);
  if (res[2]!=0) res[2][1]=a07;
  a30=(a30*a21);
  a05=(a05+a30);
  a23=(a23*a49);
  a05=(a05+a23);
  a27=(a27*a13);
  a05=(a05+a27);
  if (res[2]!=0) res[2][2]=a05;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_expected_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_expected_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_expected_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_expected_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_expected_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_expected_casadi_n_in(void) { return 10;}

CASADI_SYMBOL_EXPORT casadi_int vas_expected_casadi_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real vas_expected_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_expected_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "lever_b";
    case 6: return "flexure";
    case 7: return "flexure_rate";
    case 8: return "gyro_scale";
    case 9: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_expected_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_v_m_n";
    case 1: return "out_q_m2n_wxyz";
    case 2: return "out_omega_nb_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_expected_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s0;
    case 7: return casadi_s0;
    case 8: return casadi_s0;
    case 9: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_expected_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_expected_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_expected_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


