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
  casadi_real a48, a49, a50, a51, a52, a53, a54;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=2.;
  a03=arg[2]? arg[2][1] : 0;
  a04=(a02*a03);
  a05=arg[2]? arg[2][3] : 0;
  a06=(a04*a05);
  a07=arg[2]? arg[2][0] : 0;
  a08=(a02*a07);
  a09=arg[2]? arg[2][2] : 0;
  a10=(a08*a09);
  a11=(a06-a10);
  a12=(a01*a11);
  a13=arg[5]? arg[5][1] : 0;
  a14=(a08*a03);
  a15=(a02*a09);
  a15=(a15*a05);
  a16=(a14+a15);
  a17=(a13*a16);
  a12=(a12+a17);
  a17=arg[5]? arg[5][2] : 0;
  a18=(a05*a05);
  a19=(a07*a07);
  a20=(a09*a09);
  a21=(a19-a20);
  a22=(a18+a21);
  a23=(a03*a03);
  a22=(a22-a23);
  a24=(a17*a22);
  a12=(a12+a24);
  a24=arg[0]? arg[0][2] : 0;
  a25=6.3354393272928204e+06;
  a26=1.;
  a27=6.6943799901413173e-03;
  a28=arg[0]? arg[0][0] : 0;
  a29=sin(a28);
  a30=(a29*a29);
  a27=(a27*a30);
  a27=(a26-a27);
  a30=sqrt(a27);
  a27=(a27*a30);
  a25=(a25/a27);
  a25=(a24+a25);
  a25=(a00/a25);
  a27=(a12*a25);
  a00=(a00-a27);
  a27=arg[4]? arg[4][2] : 0;
  a31=arg[8]? arg[8][2] : 0;
  a31=(a26-a31);
  a31=(a27*a31);
  a32=arg[7]? arg[7][0] : 0;
  a33=arg[3]? arg[3][0] : 0;
  a34=(a02*a33);
  a35=arg[3]? arg[3][2] : 0;
  a36=(a34*a35);
  a37=arg[3]? arg[3][3] : 0;
  a38=(a02*a37);
  a39=arg[3]? arg[3][1] : 0;
  a38=(a38*a39);
  a40=(a36+a38);
  a40=(a32*a40);
  a31=(a31-a40);
  a40=arg[7]? arg[7][1] : 0;
  a41=(a02*a35);
  a41=(a41*a37);
  a42=(a34*a39);
  a43=(a41-a42);
  a43=(a40*a43);
  a31=(a31-a43);
  a43=arg[7]? arg[7][2] : 0;
  a44=(a33*a33);
  a45=(a39*a39);
  a46=(a44-a45);
  a47=(a37*a37);
  a48=(a46+a47);
  a49=(a35*a35);
  a48=(a48-a49);
  a48=(a43*a48);
  a31=(a31-a48);
  a48=arg[9]? arg[9][4] : 0;
  a50=arg[4]? arg[4][0] : 0;
  a48=(a48*a50);
  a31=(a31-a48);
  a48=arg[9]? arg[9][5] : 0;
  a51=arg[4]? arg[4][1] : 0;
  a48=(a48*a51);
  a31=(a31-a48);
  a04=(a04*a09);
  a08=(a08*a05);
  a48=(a04-a08);
  a52=(a31*a48);
  a53=arg[8]? arg[8][1] : 0;
  a53=(a26-a53);
  a53=(a51*a53);
  a02=(a02*a39);
  a02=(a02*a35);
  a34=(a34*a37);
  a54=(a02-a34);
  a54=(a32*a54);
  a53=(a53-a54);
  a46=(a46-a47);
  a46=(a46+a49);
  a46=(a40*a46);
  a53=(a53-a46);
  a42=(a42+a41);
  a42=(a43*a42);
  a53=(a53-a42);
  a42=arg[9]? arg[9][2] : 0;
  a42=(a42*a50);
  a53=(a53-a42);
  a42=arg[9]? arg[9][3] : 0;
  a42=(a42*a27);
  a53=(a53-a42);
  a10=(a10+a06);
  a06=(a53*a10);
  a52=(a52-a06);
  a52=(a01*a52);
  a06=arg[8]? arg[8][0] : 0;
  a06=(a26-a06);
  a50=(a50*a06);
  a47=(a47+a49);
  a44=(a44-a47);
  a44=(a44+a45);
  a32=(a32*a44);
  a50=(a50-a32);
  a34=(a34+a02);
  a40=(a40*a34);
  a50=(a50-a40);
  a38=(a38-a36);
  a43=(a43*a38);
  a50=(a50-a43);
  a43=arg[9]? arg[9][0] : 0;
  a43=(a43*a51);
  a50=(a50-a43);
  a43=arg[9]? arg[9][1] : 0;
  a43=(a43*a27);
  a50=(a50-a43);
  a43=(a50*a10);
  a27=(a23-a18);
  a27=(a27+a21);
  a21=(a31*a27);
  a43=(a43-a21);
  a43=(a13*a43);
  a52=(a52+a43);
  a43=(a53*a27);
  a21=(a50*a48);
  a43=(a43-a21);
  a43=(a17*a43);
  a52=(a52+a43);
  a00=(a00-a52);
  a08=(a08+a04);
  a04=(a01*a08);
  a19=(a19-a18);
  a19=(a19+a20);
  a19=(a19-a23);
  a23=(a13*a19);
  a04=(a04+a23);
  a15=(a15-a14);
  a14=(a17*a15);
  a04=(a04+a14);
  a14=arg[1]? arg[1][1] : 0;
  a23=6378137.;
  a23=(a23/a30);
  a24=(a24+a23);
  a24=(a14/a24);
  a28=cos(a28);
  a23=(a29/a28);
  a23=(a24*a23);
  a30=7.2921149999999999e-05;
  a29=(a30*a29);
  a23=(a23+a29);
  a29=(a04*a23);
  a00=(a00+a29);
  if (res[0]!=0) res[0][0]=a00;
  a00=(a01*a27);
  a29=(a13*a48);
  a00=(a00+a29);
  a29=(a17*a10);
  a00=(a00+a29);
  a29=(a00*a23);
  a14=(a14-a29);
  a29=(a31*a19);
  a20=(a53*a15);
  a29=(a29-a20);
  a29=(a01*a29);
  a20=(a50*a15);
  a18=(a31*a08);
  a20=(a20-a18);
  a20=(a13*a20);
  a29=(a29+a20);
  a20=(a53*a08);
  a18=(a50*a19);
  a20=(a20-a18);
  a20=(a17*a20);
  a29=(a29+a20);
  a14=(a14-a29);
  a30=(a30*a28);
  a24=(a24+a30);
  a12=(a12*a24);
  a14=(a14-a12);
  if (res[0]!=0) res[0][1]=a14;
  a14=arg[1]? arg[1][2] : 0;
  a04=(a04*a24);
  a14=(a14+a04);
  a04=(a31*a16);
  a12=(a53*a22);
  a04=(a04-a12);
  a01=(a01*a04);
  a04=(a50*a22);
  a12=(a31*a11);
  a04=(a04-a12);
  a13=(a13*a04);
  a01=(a01+a13);
  a13=(a53*a11);
  a04=(a50*a16);
  a13=(a13-a04);
  a17=(a17*a13);
  a01=(a01+a17);
  a14=(a14-a01);
  a00=(a00*a25);
  a14=(a14+a00);
  if (res[0]!=0) res[0][2]=a14;
  a14=2.5000000000000000e-01;
  a00=arg[6]? arg[6][0] : 0;
  a01=(a00*a00);
  a01=(a14*a01);
  a01=(a26+a01);
  a17=arg[6]? arg[6][1] : 0;
  a13=(a17*a17);
  a13=(a14*a13);
  a01=(a01+a13);
  a13=arg[6]? arg[6][2] : 0;
  a04=(a13*a13);
  a14=(a14*a04);
  a01=(a01+a14);
  a01=sqrt(a01);
  a01=(a26/a01);
  a14=(a33*a01);
  a04=5.0000000000000000e-01;
  a04=(a04*a01);
  a00=(a04*a00);
  a12=(a39*a00);
  a14=(a14-a12);
  a17=(a04*a17);
  a12=(a35*a17);
  a14=(a14-a12);
  a04=(a04*a13);
  a13=(a37*a04);
  a14=(a14-a13);
  a13=(a07*a14);
  a12=(a33*a00);
  a30=(a39*a01);
  a12=(a12+a30);
  a30=(a37*a17);
  a12=(a12+a30);
  a30=(a35*a04);
  a12=(a12-a30);
  a30=(a03*a12);
  a13=(a13+a30);
  a30=(a33*a17);
  a28=(a39*a04);
  a30=(a30+a28);
  a28=(a35*a01);
  a30=(a30+a28);
  a28=(a37*a00);
  a30=(a30-a28);
  a28=(a09*a30);
  a13=(a13+a28);
  a33=(a33*a04);
  a35=(a35*a00);
  a33=(a33+a35);
  a37=(a37*a01);
  a33=(a33+a37);
  a39=(a39*a17);
  a33=(a33-a39);
  a39=(a05*a33);
  a13=(a13+a39);
  a39=(a13*a13);
  a17=(a03*a14);
  a37=(a05*a30);
  a17=(a17+a37);
  a37=(a07*a12);
  a17=(a17-a37);
  a37=(a09*a33);
  a17=(a17-a37);
  a37=(a17*a17);
  a39=(a39+a37);
  a37=(a03*a33);
  a01=(a09*a14);
  a37=(a37+a01);
  a01=(a07*a30);
  a37=(a37-a01);
  a01=(a05*a12);
  a37=(a37-a01);
  a01=(a37*a37);
  a39=(a39+a01);
  a09=(a09*a12);
  a05=(a05*a14);
  a09=(a09+a05);
  a07=(a07*a33);
  a09=(a09-a07);
  a03=(a03*a30);
  a09=(a09-a03);
  a03=(a09*a09);
  a39=(a39+a03);
  a39=sqrt(a39);
  a26=(a26/a39);
  a13=(a13*a26);
  if (res[1]!=0) res[1][0]=a13;
  a17=(a17*a26);
  if (res[1]!=0) res[1][1]=a17;
  a37=(a37*a26);
  if (res[1]!=0) res[1][2]=a37;
  a09=(a09*a26);
  if (res[1]!=0) res[1][3]=a09;
  a10=(a31*a10);
  a48=(a53*a48);
  a10=(a10+a48);
  a27=(a50*a27);
  a10=(a10+a27);
  a10=(a10-a24);
  if (res[2]!=0) res[2][0]=a10;
  a15=(a31*a15);
  a19=(a53*a19);
  a15=(a15+a19);
  a08=(a50*a08);
  a15=(a15+a08);
  a15=(a15+a25);
  if (res[2]!=0) res[2][1]=a15;
  a31=(a31*a22);
  a53=(a53*a16);
  a31=(a31+a53);
  a50=(a50*a11);
  a31=(a31+a50);
  a31=(a31+a23);
  if (res[2]!=0) res[2][2]=a31;
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


