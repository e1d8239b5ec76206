/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_F_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vas_F_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_F_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_F_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {6, 1, 1};
static const casadi_int casadi_s3[3] = {107, 1, 1};

/* vas_F_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],f_b[3],omega_ib_b[3],flexure_omega[3],flexure_damping[3],gyro_scale[3],accel_scale[3],gyro_axes[6],accel_axes[3],gyro_bias_beta[3],accel_bias_beta[3])->(out_F[107]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41;
  a00=arg[0]? arg[0][0] : 0;
  a01=sin(a00);
  a00=cos(a00);
  a02=(a01/a00);
  a03=arg[1]? arg[1][1] : 0;
  a04=1.;
  a05=arg[0]? arg[0][2] : 0;
  a06=6378137.;
  a07=6.6943799901413173e-03;
  a08=(a01*a01);
  a07=(a07*a08);
  a07=(a04-a07);
  a08=sqrt(a07);
  a06=(a06/a08);
  a06=(a05+a06);
  a06=(a04/a06);
  a03=(a03*a06);
  a09=(a02*a03);
  a10=7.2921149999999999e-05;
  a01=(a10*a01);
  a11=(a09+a01);
  a12=(-a11);
  if (res[0]!=0) res[0][0]=a12;
  a12=arg[1]? arg[1][0] : 0;
  a13=6.3354393272928204e+06;
  a07=(a07*a08);
  a13=(a13/a07);
  a05=(a05+a13);
  a05=(a04/a05);
  a13=(a12*a05);
  if (res[0]!=0) res[0][1]=a13;
  if (res[0]!=0) res[0][2]=a06;
  a07=arg[7]? arg[7][0] : 0;
  a07=(a04-a07);
  a08=arg[2]? arg[2][1] : 0;
  a14=(a08*a08);
  a15=arg[2]? arg[2][2] : 0;
  a16=(a15*a15);
  a17=(a14-a16);
  a18=arg[2]? arg[2][0] : 0;
  a19=(a18*a18);
  a20=arg[2]? arg[2][3] : 0;
  a21=(a20*a20);
  a22=(a19-a21);
  a17=(a17+a22);
  a23=(a07*a17);
  a24=arg[9]? arg[9][2] : 0;
  a25=2.;
  a26=(a25*a08);
  a27=(a26*a15);
  a18=(a25*a18);
  a28=(a18*a20);
  a29=(a27-a28);
  a30=(a24*a29);
  a23=(a23-a30);
  a30=arg[9]? arg[9][4] : 0;
  a31=(a18*a15);
  a26=(a26*a20);
  a32=(a31+a26);
  a33=(a30*a32);
  a23=(a23-a33);
  if (res[0]!=0) res[0][3]=a23;
  a23=arg[7]? arg[7][1] : 0;
  a23=(a04-a23);
  a33=(a23*a29);
  a34=arg[9]? arg[9][0] : 0;
  a35=(a34*a17);
  a33=(a33-a35);
  a35=arg[9]? arg[9][5] : 0;
  a36=(a35*a32);
  a33=(a33-a36);
  if (res[0]!=0) res[0][4]=a33;
  a33=arg[7]? arg[7][2] : 0;
  a33=(a04-a33);
  a36=(a33*a32);
  a37=arg[9]? arg[9][1] : 0;
  a38=(a37*a17);
  a36=(a36-a38);
  a38=arg[9]? arg[9][3] : 0;
  a39=(a38*a29);
  a36=(a36-a39);
  if (res[0]!=0) res[0][5]=a36;
  a36=arg[4]? arg[4][0] : 0;
  a39=(a36*a17);
  if (res[0]!=0) res[0][6]=a39;
  a39=arg[4]? arg[4][1] : 0;
  a40=(a39*a29);
  if (res[0]!=0) res[0][7]=a40;
  a40=arg[4]? arg[4][2] : 0;
  a41=(a40*a32);
  if (res[0]!=0) res[0][8]=a41;
  a41=(a39*a17);
  if (res[0]!=0) res[0][9]=a41;
  a41=(a40*a17);
  if (res[0]!=0) res[0][10]=a41;
  a41=(a36*a29);
  if (res[0]!=0) res[0][11]=a41;
  a41=(a40*a29);
  if (res[0]!=0) res[0][12]=a41;
  a41=(a36*a32);
  if (res[0]!=0) res[0][13]=a41;
  a41=(a39*a32);
  if (res[0]!=0) res[0][14]=a41;
  if (res[0]!=0) res[0][15]=a11;
  a10=(a10*a00);
  a10=(a03+a10);
  if (res[0]!=0) res[0][16]=a10;
  a11=(-a05);
  if (res[0]!=0) res[0][17]=a11;
  a28=(a28+a27);
  a27=(a07*a28);
  a22=(a16+a22);
  a22=(a22-a14);
  a11=(a24*a22);
  a27=(a27-a11);
  a15=(a25*a15);
  a15=(a15*a20);
  a18=(a18*a08);
  a08=(a15-a18);
  a20=(a30*a08);
  a27=(a27-a20);
  if (res[0]!=0) res[0][18]=a27;
  a27=(a23*a22);
  a20=(a34*a28);
  a27=(a27-a20);
  a20=(a35*a08);
  a27=(a27-a20);
  if (res[0]!=0) res[0][19]=a27;
  a27=(a33*a08);
  a20=(a37*a28);
  a27=(a27-a20);
  a20=(a38*a22);
  a27=(a27-a20);
  if (res[0]!=0) res[0][20]=a27;
  a27=(a36*a28);
  if (res[0]!=0) res[0][21]=a27;
  a27=(a39*a22);
  if (res[0]!=0) res[0][22]=a27;
  a27=(a40*a08);
  if (res[0]!=0) res[0][23]=a27;
  a27=(a39*a28);
  if (res[0]!=0) res[0][24]=a27;
  a27=(a40*a28);
  if (res[0]!=0) res[0][25]=a27;
  a27=(a36*a22);
  if (res[0]!=0) res[0][26]=a27;
  a27=(a40*a22);
  if (res[0]!=0) res[0][27]=a27;
  a27=(a36*a08);
  if (res[0]!=0) res[0][28]=a27;
  a27=(a39*a08);
  if (res[0]!=0) res[0][29]=a27;
  a27=(-a13);
  if (res[0]!=0) res[0][30]=a27;
  a10=(-a10);
  if (res[0]!=0) res[0][31]=a10;
  a02=(a02*a06);
  a10=(-a02);
  if (res[0]!=0) res[0][32]=a10;
  a26=(a26-a31);
  a07=(a07*a26);
  a18=(a18+a15);
  a24=(a24*a18);
  a07=(a07-a24);
  a19=(a19-a16);
  a19=(a19+a21);
  a19=(a19-a14);
  a30=(a30*a19);
  a07=(a07-a30);
  if (res[0]!=0) res[0][33]=a07;
  a23=(a23*a18);
  a34=(a34*a26);
  a23=(a23-a34);
  a35=(a35*a19);
  a23=(a23-a35);
  if (res[0]!=0) res[0][34]=a23;
  a33=(a33*a19);
  a37=(a37*a26);
  a33=(a33-a37);
  a38=(a38*a18);
  a33=(a33-a38);
  if (res[0]!=0) res[0][35]=a33;
  a33=(a36*a26);
  if (res[0]!=0) res[0][36]=a33;
  a33=(a39*a18);
  if (res[0]!=0) res[0][37]=a33;
  a33=(a40*a19);
  if (res[0]!=0) res[0][38]=a33;
  a33=(a39*a26);
  if (res[0]!=0) res[0][39]=a33;
  a33=(a40*a26);
  if (res[0]!=0) res[0][40]=a33;
  a33=(a36*a18);
  if (res[0]!=0) res[0][41]=a33;
  a40=(a40*a18);
  if (res[0]!=0) res[0][42]=a40;
  a36=(a36*a19);
  if (res[0]!=0) res[0][43]=a36;
  a39=(a39*a19);
  if (res[0]!=0) res[0][44]=a39;
  a39=arg[8]? arg[8][1] : 0;
  a39=(a04-a39);
  a36=arg[3]? arg[3][1] : 0;
  a40=(a39*a36);
  a33=arg[3]? arg[3][0] : 0;
  a38=arg[10]? arg[10][0] : 0;
  a37=(a33*a38);
  a40=(a40-a37);
  a37=(a40*a18);
  a23=arg[8]? arg[8][2] : 0;
  a23=(a04-a23);
  a35=arg[3]? arg[3][2] : 0;
  a34=(a23*a35);
  a07=arg[10]? arg[10][1] : 0;
  a30=(a33*a07);
  a34=(a34-a30);
  a30=arg[10]? arg[10][2] : 0;
  a14=(a36*a30);
  a34=(a34-a14);
  a14=(a34*a19);
  a37=(a37+a14);
  a14=arg[8]? arg[8][0] : 0;
  a14=(a04-a14);
  a21=(a14*a26);
  a16=(a21*a33);
  a37=(a37+a16);
  a16=(-a37);
  if (res[0]!=0) res[0][45]=a16;
  a16=(a40*a22);
  a24=(a34*a08);
  a16=(a16+a24);
  a24=(a14*a28);
  a15=(a24*a33);
  a16=(a16+a15);
  if (res[0]!=0) res[0][46]=a16;
  a15=arg[1]? arg[1][2] : 0;
  a05=(a15*a05);
  if (res[0]!=0) res[0][47]=a05;
  a01=(-a01);
  a01=(a25*a01);
  a01=(a01-a09);
  a09=(a01-a09);
  if (res[0]!=0) res[0][48]=a09;
  if (res[0]!=0) res[0][49]=a13;
  a09=(a38*a29);
  a05=(a07*a32);
  a09=(a09+a05);
  a14=(a14*a17);
  a09=(a09-a14);
  if (res[0]!=0) res[0][50]=a09;
  a09=(a30*a32);
  a05=(a39*a29);
  a09=(a09-a05);
  if (res[0]!=0) res[0][51]=a09;
  a09=(a23*a32);
  a09=(-a09);
  if (res[0]!=0) res[0][52]=a09;
  a17=(a33*a17);
  a17=(-a17);
  if (res[0]!=0) res[0][53]=a17;
  a17=(a36*a29);
  a17=(-a17);
  if (res[0]!=0) res[0][54]=a17;
  a17=(a35*a32);
  a17=(-a17);
  if (res[0]!=0) res[0][55]=a17;
  a17=(a33*a29);
  a17=(-a17);
  if (res[0]!=0) res[0][56]=a17;
  a17=(a33*a32);
  a17=(-a17);
  if (res[0]!=0) res[0][57]=a17;
  a17=(a36*a32);
  a17=(-a17);
  if (res[0]!=0) res[0][58]=a17;
  if (res[0]!=0) res[0][59]=a37;
  a40=(a40*a29);
  a34=(a34*a32);
  a40=(a40+a34);
  a14=(a14*a33);
  a40=(a40+a14);
  a14=(-a40);
  if (res[0]!=0) res[0][60]=a14;
  a01=(-a01);
  if (res[0]!=0) res[0][61]=a01;
  a15=(a15*a06);
  a12=(a12*a02);
  a15=(a15+a12);
  if (res[0]!=0) res[0][62]=a15;
  a15=1.4584230000000000e-04;
  a15=(a15*a00);
  a15=(a15+a03);
  if (res[0]!=0) res[0][63]=a15;
  a00=(a38*a22);
  a12=(a07*a08);
  a00=(a00+a12);
  a00=(a00-a24);
  if (res[0]!=0) res[0][64]=a00;
  a00=(a30*a08);
  a24=(a39*a22);
  a00=(a00-a24);
  if (res[0]!=0) res[0][65]=a00;
  a00=(a23*a08);
  a00=(-a00);
  if (res[0]!=0) res[0][66]=a00;
  a28=(a33*a28);
  a28=(-a28);
  if (res[0]!=0) res[0][67]=a28;
  a28=(a36*a22);
  a28=(-a28);
  if (res[0]!=0) res[0][68]=a28;
  a28=(a35*a08);
  a28=(-a28);
  if (res[0]!=0) res[0][69]=a28;
  a22=(a33*a22);
  a22=(-a22);
  if (res[0]!=0) res[0][70]=a22;
  a22=(a33*a08);
  a22=(-a22);
  if (res[0]!=0) res[0][71]=a22;
  a08=(a36*a08);
  a08=(-a08);
  if (res[0]!=0) res[0][72]=a08;
  a16=(-a16);
  if (res[0]!=0) res[0][73]=a16;
  if (res[0]!=0) res[0][74]=a40;
  a13=(a25*a13);
  a13=(-a13);
  if (res[0]!=0) res[0][75]=a13;
  a15=(a15+a03);
  a15=(-a15);
  if (res[0]!=0) res[0][76]=a15;
  a38=(a38*a18);
  a07=(a07*a19);
  a38=(a38+a07);
  a38=(a38-a21);
  if (res[0]!=0) res[0][77]=a38;
  a30=(a30*a19);
  a39=(a39*a18);
  a30=(a30-a39);
  if (res[0]!=0) res[0][78]=a30;
  a23=(a23*a19);
  a23=(-a23);
  if (res[0]!=0) res[0][79]=a23;
  a26=(a33*a26);
  a26=(-a26);
  if (res[0]!=0) res[0][80]=a26;
  a26=(a36*a18);
  a26=(-a26);
  if (res[0]!=0) res[0][81]=a26;
  a35=(a35*a19);
  a35=(-a35);
  if (res[0]!=0) res[0][82]=a35;
  a18=(a33*a18);
  a18=(-a18);
  if (res[0]!=0) res[0][83]=a18;
  a33=(a33*a19);
  a33=(-a33);
  if (res[0]!=0) res[0][84]=a33;
  a36=(a36*a19);
  a36=(-a36);
  if (res[0]!=0) res[0][85]=a36;
  a36=arg[11]? arg[11][0] : 0;
  a19=(-a36);
  if (res[0]!=0) res[0][86]=a19;
  if (res[0]!=0) res[0][87]=a36;
  a36=arg[11]? arg[11][1] : 0;
  a19=(-a36);
  if (res[0]!=0) res[0][88]=a19;
  if (res[0]!=0) res[0][89]=a36;
  a36=arg[11]? arg[11][2] : 0;
  a19=(-a36);
  if (res[0]!=0) res[0][90]=a19;
  if (res[0]!=0) res[0][91]=a36;
  a36=arg[12]? arg[12][0] : 0;
  a19=(-a36);
  if (res[0]!=0) res[0][92]=a19;
  if (res[0]!=0) res[0][93]=a36;
  a36=arg[12]? arg[12][1] : 0;
  a19=(-a36);
  if (res[0]!=0) res[0][94]=a19;
  if (res[0]!=0) res[0][95]=a36;
  a36=arg[12]? arg[12][2] : 0;
  a19=(-a36);
  if (res[0]!=0) res[0][96]=a19;
  if (res[0]!=0) res[0][97]=a36;
  if (res[0]!=0) res[0][98]=a04;
  if (res[0]!=0) res[0][99]=a04;
  if (res[0]!=0) res[0][100]=a04;
  a04=arg[5]? arg[5][0] : 0;
  a36=(a04*a04);
  a36=(-a36);
  if (res[0]!=0) res[0][101]=a36;
  a36=arg[6]? arg[6][0] : 0;
  a36=(a25*a36);
  a36=(a36*a04);
  a36=(-a36);
  if (res[0]!=0) res[0][102]=a36;
  a36=arg[5]? arg[5][1] : 0;
  a04=(a36*a36);
  a04=(-a04);
  if (res[0]!=0) res[0][103]=a04;
  a04=arg[6]? arg[6][1] : 0;
  a04=(a25*a04);
  a04=(a04*a36);
  a04=(-a04);
  if (res[0]!=0) res[0][104]=a04;
  a04=arg[5]? arg[5][2] : 0;
  a36=(a04*a04);
  a36=(-a36);
  if (res[0]!=0) res[0][105]=a36;
  a36=arg[6]? arg[6][2] : 0;
  a25=(a25*a36);
  a25=(a25*a04);
  a25=(-a25);
  if (res[0]!=0) res[0][106]=a25;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_F_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_F_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_F_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_F_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_F_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_F_casadi_n_in(void) { return 13;}

CASADI_SYMBOL_EXPORT casadi_int vas_F_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_F_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_F_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "f_b";
    case 4: return "omega_ib_b";
    case 5: return "flexure_omega";
    case 6: return "flexure_damping";
    case 7: return "gyro_scale";
    case 8: return "accel_scale";
    case 9: return "gyro_axes";
    case 10: return "accel_axes";
    case 11: return "gyro_bias_beta";
    case 12: return "accel_bias_beta";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_F_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_F";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_F_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s0;
    case 7: return casadi_s0;
    case 8: return casadi_s0;
    case 9: return casadi_s2;
    case 10: return casadi_s0;
    case 11: return casadi_s0;
    case 12: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_F_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_F_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 13;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_F_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 13*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


