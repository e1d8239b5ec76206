/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_Qc_casadi__ ## ID
#endif

#include <math.h>

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
#define casadi_s4 CASADI_PREFIX(s4)
#define casadi_sq CASADI_PREFIX(sq)

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

static casadi_real casadi_sq(casadi_real x) { return x*x;}

/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void vas_Qc_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_Qc_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_Qc_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {6, 1, 1};
static const casadi_int casadi_s4[3] = {31, 1, 1};

/* vas_Qc_casadi:(q_b2n_wxyz[4],gyro_noise[3],accel_noise[3],gyro_bias_noise[3],accel_bias_noise[3],mu_noise[3],tau_noise,flexure_noise[3],gyro_scale[3],accel_scale[3],gyro_axes[6],accel_axes[3])->(out_Qc[31]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37;
  a00=arg[10]? arg[10][2] : 0;
  a01=arg[0]? arg[0][1] : 0;
  a02=(2.*a01);
  a03=arg[0]? arg[0][2] : 0;
  a04=(a02*a03);
  a05=arg[0]? arg[0][0] : 0;
  a06=(2.*a05);
  a07=arg[0]? arg[0][3] : 0;
  a08=(a06*a07);
  a09=(a04-a08);
  a10=(a00*a09);
  a11=arg[10]? arg[10][4] : 0;
  a12=(a06*a03);
  a02=(a02*a07);
  a13=(a12+a02);
  a14=(a11*a13);
  a10=(a10+a14);
  a14=1.;
  a15=arg[8]? arg[8][0] : 0;
  a15=(a14-a15);
  a16=casadi_sq(a01);
  a17=casadi_sq(a03);
  a18=(a16-a17);
  a05=casadi_sq(a05);
  a19=casadi_sq(a07);
  a20=(a05-a19);
  a18=(a18+a20);
  a21=(a15*a18);
  a10=(a10-a21);
  a21=arg[1]? arg[1][0] : 0;
  a21=casadi_sq(a21);
  a22=(a10*a21);
  a22=(a22*a10);
  a23=arg[10]? arg[10][0] : 0;
  a24=(a23*a18);
  a25=arg[10]? arg[10][5] : 0;
  a26=(a25*a13);
  a24=(a24+a26);
  a26=arg[8]? arg[8][1] : 0;
  a26=(a14-a26);
  a27=(a26*a09);
  a24=(a24-a27);
  a27=arg[1]? arg[1][1] : 0;
  a27=casadi_sq(a27);
  a28=(a24*a27);
  a28=(a28*a24);
  a22=(a22+a28);
  a28=arg[10]? arg[10][1] : 0;
  a29=(a28*a18);
  a30=arg[10]? arg[10][3] : 0;
  a31=(a30*a09);
  a29=(a29+a31);
  a31=arg[8]? arg[8][2] : 0;
  a31=(a14-a31);
  a32=(a31*a13);
  a29=(a29-a32);
  a32=arg[1]? arg[1][2] : 0;
  a32=casadi_sq(a32);
  a33=(a29*a32);
  a33=(a33*a29);
  a22=(a22+a33);
  if (res[0]!=0) res[0][0]=a22;
  a20=(a17+a20);
  a20=(a20-a16);
  a22=(a00*a20);
  a03=(2.*a03);
  a03=(a03*a07);
  a06=(a06*a01);
  a01=(a03-a06);
  a07=(a11*a01);
  a22=(a22+a07);
  a08=(a08+a04);
  a04=(a15*a08);
  a22=(a22-a04);
  a04=(a22*a21);
  a07=(a04*a10);
  a33=(a23*a08);
  a34=(a25*a01);
  a33=(a33+a34);
  a34=(a26*a20);
  a33=(a33-a34);
  a34=(a33*a27);
  a35=(a34*a24);
  a07=(a07+a35);
  a35=(a28*a08);
  a36=(a30*a20);
  a35=(a35+a36);
  a36=(a31*a01);
  a35=(a35-a36);
  a36=(a35*a32);
  a37=(a36*a29);
  a07=(a07+a37);
  if (res[0]!=0) res[0][1]=a07;
  a06=(a06+a03);
  a00=(a00*a06);
  a05=(a05-a17);
  a05=(a05+a19);
  a05=(a05-a16);
  a11=(a11*a05);
  a00=(a00+a11);
  a02=(a02-a12);
  a15=(a15*a02);
  a00=(a00-a15);
  a21=(a00*a21);
  a10=(a21*a10);
  a23=(a23*a02);
  a25=(a25*a05);
  a23=(a23+a25);
  a26=(a26*a06);
  a23=(a23-a26);
  a27=(a23*a27);
  a24=(a27*a24);
  a10=(a10+a24);
  a28=(a28*a02);
  a30=(a30*a06);
  a28=(a28+a30);
  a31=(a31*a05);
  a28=(a28-a31);
  a32=(a28*a32);
  a29=(a32*a29);
  a10=(a10+a29);
  if (res[0]!=0) res[0][2]=a10;
  if (res[0]!=0) res[0][3]=a07;
  a04=(a04*a22);
  a34=(a34*a33);
  a04=(a04+a34);
  a36=(a36*a35);
  a04=(a04+a36);
  if (res[0]!=0) res[0][4]=a04;
  a22=(a21*a22);
  a33=(a27*a33);
  a22=(a22+a33);
  a35=(a32*a35);
  a22=(a22+a35);
  if (res[0]!=0) res[0][5]=a22;
  if (res[0]!=0) res[0][6]=a10;
  if (res[0]!=0) res[0][7]=a22;
  a21=(a21*a00);
  a27=(a27*a23);
  a21=(a21+a27);
  a32=(a32*a28);
  a21=(a21+a32);
  if (res[0]!=0) res[0][8]=a21;
  a21=arg[9]? arg[9][0] : 0;
  a21=(a14-a21);
  a18=(a21*a18);
  a32=arg[11]? arg[11][0] : 0;
  a28=(a32*a09);
  a18=(a18-a28);
  a28=arg[11]? arg[11][1] : 0;
  a27=(a28*a13);
  a18=(a18-a27);
  a27=arg[2]? arg[2][0] : 0;
  a27=casadi_sq(a27);
  a23=(a18*a27);
  a23=(a23*a18);
  a00=arg[9]? arg[9][1] : 0;
  a00=(a14-a00);
  a09=(a00*a09);
  a22=arg[11]? arg[11][2] : 0;
  a10=(a22*a13);
  a09=(a09-a10);
  a10=arg[2]? arg[2][1] : 0;
  a10=casadi_sq(a10);
  a35=(a09*a10);
  a35=(a35*a09);
  a23=(a23+a35);
  a35=arg[9]? arg[9][2] : 0;
  a14=(a14-a35);
  a13=(a14*a13);
  a35=arg[2]? arg[2][2] : 0;
  a35=casadi_sq(a35);
  a33=(a13*a35);
  a33=(a33*a13);
  a23=(a23+a33);
  if (res[0]!=0) res[0][9]=a23;
  a08=(a21*a08);
  a23=(a32*a20);
  a08=(a08-a23);
  a23=(a28*a01);
  a08=(a08-a23);
  a23=(a08*a27);
  a33=(a23*a18);
  a20=(a00*a20);
  a04=(a22*a01);
  a20=(a20-a04);
  a04=(a20*a10);
  a36=(a04*a09);
  a33=(a33+a36);
  a01=(a14*a01);
  a36=(a01*a35);
  a34=(a36*a13);
  a33=(a33+a34);
  if (res[0]!=0) res[0][10]=a33;
  a21=(a21*a02);
  a32=(a32*a06);
  a21=(a21-a32);
  a28=(a28*a05);
  a21=(a21-a28);
  a27=(a21*a27);
  a18=(a27*a18);
  a00=(a00*a06);
  a22=(a22*a05);
  a00=(a00-a22);
  a10=(a00*a10);
  a09=(a10*a09);
  a18=(a18+a09);
  a14=(a14*a05);
  a35=(a14*a35);
  a13=(a35*a13);
  a18=(a18+a13);
  if (res[0]!=0) res[0][11]=a18;
  if (res[0]!=0) res[0][12]=a33;
  a23=(a23*a08);
  a04=(a04*a20);
  a23=(a23+a04);
  a36=(a36*a01);
  a23=(a23+a36);
  if (res[0]!=0) res[0][13]=a23;
  a08=(a27*a08);
  a20=(a10*a20);
  a08=(a08+a20);
  a01=(a35*a01);
  a08=(a08+a01);
  if (res[0]!=0) res[0][14]=a08;
  if (res[0]!=0) res[0][15]=a18;
  if (res[0]!=0) res[0][16]=a08;
  a27=(a27*a21);
  a10=(a10*a00);
  a27=(a27+a10);
  a35=(a35*a14);
  a27=(a27+a35);
  if (res[0]!=0) res[0][17]=a27;
  a27=arg[3]? arg[3][0] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][18]=a27;
  a27=arg[3]? arg[3][1] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][19]=a27;
  a27=arg[3]? arg[3][2] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][20]=a27;
  a27=arg[4]? arg[4][0] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][21]=a27;
  a27=arg[4]? arg[4][1] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][22]=a27;
  a27=arg[4]? arg[4][2] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][23]=a27;
  a27=arg[5]? arg[5][0] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][24]=a27;
  a27=arg[5]? arg[5][1] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][25]=a27;
  a27=arg[5]? arg[5][2] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][26]=a27;
  a27=arg[6]? arg[6][0] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][27]=a27;
  a27=arg[7]? arg[7][0] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][28]=a27;
  a27=arg[7]? arg[7][1] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][29]=a27;
  a27=arg[7]? arg[7][2] : 0;
  a27=casadi_sq(a27);
  if (res[0]!=0) res[0][30]=a27;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_Qc_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_Qc_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_Qc_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_Qc_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_Qc_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_Qc_casadi_n_in(void) { return 12;}

CASADI_SYMBOL_EXPORT casadi_int vas_Qc_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_Qc_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_Qc_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_b2n_wxyz";
    case 1: return "gyro_noise";
    case 2: return "accel_noise";
    case 3: return "gyro_bias_noise";
    case 4: return "accel_bias_noise";
    case 5: return "mu_noise";
    case 6: return "tau_noise";
    case 7: return "flexure_noise";
    case 8: return "gyro_scale";
    case 9: return "accel_scale";
    case 10: return "gyro_axes";
    case 11: return "accel_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_Qc_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Qc";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_Qc_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s1;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    case 7: return casadi_s1;
    case 8: return casadi_s1;
    case 9: return casadi_s1;
    case 10: return casadi_s3;
    case 11: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_Qc_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_Qc_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_Qc_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


