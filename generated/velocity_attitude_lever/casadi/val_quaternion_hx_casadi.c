/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) val_quaternion_h_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void val_quaternion_h_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int val_quaternion_h_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int val_quaternion_h_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {19, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {4, 1, 1};
static const casadi_int casadi_s3[3] = {1, 1, 1};

/* val_quaternion_h_casadi:(x[19],position[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],q_m2n_wxyz[4],lag)->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51;
  a00=arg[4]? arg[4][0] : 0;
  a01=arg[3]? arg[3][1] : 0;
  a02=(a00*a01);
  a03=arg[4]? arg[4][2] : 0;
  a04=arg[3]? arg[3][3] : 0;
  a05=(a03*a04);
  a02=(a02+a05);
  a05=arg[4]? arg[4][1] : 0;
  a06=arg[3]? arg[3][0] : 0;
  a07=(a05*a06);
  a02=(a02-a07);
  a07=arg[4]? arg[4][3] : 0;
  a08=arg[3]? arg[3][2] : 0;
  a09=(a07*a08);
  a02=(a02-a09);
  a09=5.0000000000000000e-01;
  a10=1.0000000000000001e-30;
  a11=arg[7]? arg[7][0] : 0;
  a12=casadi_sq(a11);
  a13=arg[2]? arg[2][0] : 0;
  a14=arg[1]? arg[1][2] : 0;
  a15=6.3354393272928204e+06;
  a16=1.;
  a17=6.6943799901413173e-03;
  a18=arg[1]? arg[1][0] : 0;
  a19=sin(a18);
  a20=casadi_sq(a19);
  a17=(a17*a20);
  a16=(a16-a17);
  a17=sqrt(a16);
  a16=(a16*a17);
  a15=(a15/a16);
  a15=(a14+a15);
  a13=(a13/a15);
  a15=arg[5]? arg[5][0] : 0;
  a16=(2.*a06);
  a20=(a16*a04);
  a21=(2.*a08);
  a22=(a21*a01);
  a22=(a20+a22);
  a22=(a15*a22);
  a22=(a13+a22);
  a23=arg[5]? arg[5][1] : 0;
  a24=casadi_sq(a06);
  a25=casadi_sq(a01);
  a26=(a24-a25);
  a27=casadi_sq(a04);
  a28=(a26-a27);
  a29=casadi_sq(a08);
  a28=(a28+a29);
  a28=(a23*a28);
  a22=(a22+a28);
  a28=arg[5]? arg[5][2] : 0;
  a30=(a08*a04);
  a30=(2.*a30);
  a31=(a16*a01);
  a30=(a30-a31);
  a30=(a28*a30);
  a22=(a22+a30);
  a30=casadi_sq(a22);
  a30=(a12*a30);
  a30=(a10+a30);
  a24=(a24-a27);
  a24=(a24+a25);
  a24=(a24-a29);
  a24=(a15*a24);
  a25=7.2921149999999999e-05;
  a18=cos(a18);
  a32=(a25*a18);
  a33=arg[2]? arg[2][1] : 0;
  a34=6378137.;
  a34=(a34/a17);
  a14=(a14+a34);
  a33=(a33/a14);
  a32=(a32+a33);
  a24=(a24-a32);
  a14=(a01*a08);
  a14=(2.*a14);
  a14=(a14-a20);
  a14=(a23*a14);
  a24=(a24+a14);
  a16=(a16*a08);
  a14=(a01*a04);
  a14=(2.*a14);
  a20=(a16+a14);
  a20=(a28*a20);
  a24=(a24+a20);
  a20=casadi_sq(a24);
  a20=(a12*a20);
  a30=(a30+a20);
  a25=(a25*a19);
  a19=(a19/a18);
  a33=(a33*a19);
  a25=(a25+a33);
  a14=(a14-a16);
  a14=(a15*a14);
  a14=(a25+a14);
  a21=(a21*a04);
  a31=(a31+a21);
  a31=(a23*a31);
  a14=(a14+a31);
  a27=(a27+a26);
  a27=(a27-a29);
  a27=(a28*a27);
  a14=(a14+a27);
  a27=casadi_sq(a14);
  a12=(a12*a27);
  a30=(a30+a12);
  a30=sqrt(a30);
  a12=(a09*a30);
  a27=cos(a12);
  a29=(a02*a27);
  a26=(a00*a04);
  a31=(a05*a08);
  a26=(a26+a31);
  a31=(a03*a01);
  a26=(a26-a31);
  a31=(a07*a06);
  a26=(a26-a31);
  a12=sin(a12);
  a12=(a11*a12);
  a12=(a12/a30);
  a22=(a22*a12);
  a30=(a26*a22);
  a29=(a29-a30);
  a30=(a00*a06);
  a31=(a05*a01);
  a30=(a30+a31);
  a31=(a03*a08);
  a30=(a30+a31);
  a31=(a07*a04);
  a30=(a30+a31);
  a24=(a24*a12);
  a31=(a30*a24);
  a29=(a29-a31);
  a31=(a00*a08);
  a21=(a07*a01);
  a31=(a31+a21);
  a21=(a05*a04);
  a31=(a31-a21);
  a21=(a03*a06);
  a31=(a31-a21);
  a14=(a14*a12);
  a12=(a31*a14);
  a29=(a29+a12);
  a12=arg[6]? arg[6][1] : 0;
  a21=(a29*a12);
  a16=(a27*a31);
  a33=(a02*a14);
  a16=(a16-a33);
  a33=(a22*a30);
  a16=(a16-a33);
  a33=(a26*a24);
  a16=(a16+a33);
  a33=arg[6]? arg[6][2] : 0;
  a19=(a16*a33);
  a21=(a21+a19);
  a19=(a27*a26);
  a18=(a30*a14);
  a19=(a19-a18);
  a18=(a24*a31);
  a19=(a19-a18);
  a18=(a02*a22);
  a19=(a19+a18);
  a18=arg[6]? arg[6][3] : 0;
  a20=(a19*a18);
  a21=(a21+a20);
  a27=(a27*a30);
  a02=(a02*a24);
  a27=(a27+a02);
  a26=(a26*a14);
  a27=(a27+a26);
  a22=(a22*a31);
  a27=(a27+a22);
  a22=arg[6]? arg[6][0] : 0;
  a31=(a27*a22);
  a21=(a21+a31);
  a31=casadi_sq(a21);
  a31=(a10+a31);
  a31=sqrt(a31);
  a21=(a21/a31);
  a31=(2.*a22);
  a26=(a29*a31);
  a14=(2.*a33);
  a02=(a19*a14);
  a26=(a26+a02);
  a02=(2.*a18);
  a24=(a16*a02);
  a26=(a26-a24);
  a24=(2.*a12);
  a30=(a27*a24);
  a26=(a26-a30);
  a26=(a21*a26);
  a30=arg[0]? arg[0][2] : 0;
  a20=casadi_sq(a30);
  a20=(a10+a20);
  a34=arg[0]? arg[0][1] : 0;
  a17=casadi_sq(a34);
  a20=(a20+a17);
  a17=arg[0]? arg[0][0] : 0;
  a35=casadi_sq(a17);
  a20=(a20+a35);
  a20=sqrt(a20);
  a35=(a09*a20);
  a36=cos(a35);
  a37=(a36*a01);
  a35=sin(a35);
  a35=(a35/a20);
  a20=(a35*a04);
  a38=(a20*a34);
  a37=(a37+a38);
  a38=(a35*a17);
  a39=(a38*a06);
  a37=(a37+a39);
  a39=(a35*a08);
  a40=(a39*a30);
  a37=(a37-a40);
  a40=arg[0]? arg[0][12] : 0;
  a41=casadi_sq(a40);
  a41=(a10+a41);
  a42=arg[0]? arg[0][13] : 0;
  a43=casadi_sq(a42);
  a41=(a41+a43);
  a43=arg[0]? arg[0][14] : 0;
  a44=casadi_sq(a43);
  a41=(a41+a44);
  a41=sqrt(a41);
  a44=(a09*a41);
  a45=cos(a44);
  a46=(a45*a00);
  a44=sin(a44);
  a44=(a44/a41);
  a40=(a44*a40);
  a41=(a40*a05);
  a46=(a46-a41);
  a41=(a44*a07);
  a47=(a41*a43);
  a46=(a46-a47);
  a47=(a44*a42);
  a48=(a47*a03);
  a46=(a46-a48);
  a48=(a37*a46);
  a08=(a36*a08);
  a49=(a35*a30);
  a50=(a49*a01);
  a08=(a08+a50);
  a35=(a35*a34);
  a50=(a35*a06);
  a08=(a08+a50);
  a50=(a20*a17);
  a08=(a08-a50);
  a50=(a47*a05);
  a51=(a45*a07);
  a50=(a50-a51);
  a51=(a40*a03);
  a50=(a50-a51);
  a44=(a44*a43);
  a43=(a44*a00);
  a50=(a50-a43);
  a43=(a08*a50);
  a48=(a48+a43);
  a43=(a44*a03);
  a51=(a45*a05);
  a43=(a43-a51);
  a51=(a40*a00);
  a43=(a43-a51);
  a41=(a41*a42);
  a43=(a43-a41);
  a41=(a36*a06);
  a20=(a20*a30);
  a41=(a41-a20);
  a38=(a38*a01);
  a41=(a41-a38);
  a34=(a39*a34);
  a41=(a41-a34);
  a34=(a43*a41);
  a48=(a48+a34);
  a36=(a36*a04);
  a39=(a39*a17);
  a36=(a36+a39);
  a49=(a49*a06);
  a36=(a36+a49);
  a35=(a35*a01);
  a36=(a36-a35);
  a40=(a40*a07);
  a45=(a45*a03);
  a40=(a40-a45);
  a44=(a44*a05);
  a40=(a40-a44);
  a47=(a47*a00);
  a40=(a40-a47);
  a47=(a36*a40);
  a48=(a48-a47);
  a47=arg[0]? arg[0][15] : 0;
  a11=(a11-a47);
  a47=casadi_sq(a11);
  a00=arg[0]? arg[0][6] : 0;
  a00=(a00+a15);
  a15=(2.*a41);
  a44=(a36*a15);
  a05=(2.*a08);
  a45=(a37*a05);
  a45=(a44+a45);
  a45=(a00*a45);
  a13=(a13+a45);
  a45=arg[0]? arg[0][8] : 0;
  a45=(a45+a28);
  a05=(a36*a05);
  a28=(a37*a15);
  a03=(a05-a28);
  a03=(a45*a03);
  a13=(a13+a03);
  a03=arg[0]? arg[0][7] : 0;
  a03=(a03+a23);
  a23=casadi_sq(a37);
  a07=casadi_sq(a41);
  a35=(a23-a07);
  a01=casadi_sq(a36);
  a49=casadi_sq(a08);
  a06=(a01-a49);
  a35=(a35+a06);
  a35=(a03*a35);
  a13=(a13-a35);
  a35=casadi_sq(a13);
  a35=(a47*a35);
  a35=(a10+a35);
  a39=(a37*a36);
  a39=(2.*a39);
  a15=(a08*a15);
  a17=(a39+a15);
  a17=(a45*a17);
  a01=(a01-a07);
  a01=(a01+a49);
  a01=(a01-a23);
  a01=(a00*a01);
  a32=(a32+a01);
  a17=(a17-a32);
  a32=(a37*a08);
  a32=(2.*a32);
  a32=(a32-a44);
  a32=(a03*a32);
  a17=(a17+a32);
  a32=casadi_sq(a17);
  a32=(a47*a32);
  a35=(a35+a32);
  a39=(a39-a15);
  a00=(a00*a39);
  a25=(a25+a00);
  a07=(a07+a06);
  a07=(a07-a23);
  a45=(a45*a07);
  a25=(a25+a45);
  a05=(a05+a28);
  a03=(a03*a05);
  a25=(a25+a03);
  a03=casadi_sq(a25);
  a47=(a47*a03);
  a35=(a35+a47);
  a35=sqrt(a35);
  a09=(a09*a35);
  a47=cos(a09);
  a03=(a48*a47);
  a05=(a37*a40);
  a28=(a46*a36);
  a05=(a05+a28);
  a28=(a50*a41);
  a05=(a05+a28);
  a28=(a08*a43);
  a05=(a05-a28);
  a09=sin(a09);
  a11=(a11*a09);
  a11=(a11/a35);
  a13=(a13*a11);
  a35=(a05*a13);
  a03=(a03-a35);
  a35=(a46*a41);
  a09=(a37*a43);
  a35=(a35-a09);
  a09=(a08*a40);
  a35=(a35-a09);
  a09=(a50*a36);
  a35=(a35-a09);
  a17=(a17*a11);
  a09=(a35*a17);
  a03=(a03-a09);
  a46=(a46*a08);
  a36=(a36*a43);
  a46=(a46+a36);
  a40=(a40*a41);
  a46=(a46+a40);
  a37=(a37*a50);
  a46=(a46-a37);
  a25=(a25*a11);
  a11=(a46*a25);
  a03=(a03+a11);
  a12=(a03*a12);
  a11=(a47*a05);
  a37=(a46*a17);
  a50=(a25*a35);
  a37=(a37+a50);
  a11=(a11-a37);
  a37=(a48*a13);
  a11=(a11+a37);
  a18=(a11*a18);
  a12=(a12+a18);
  a18=(a46*a47);
  a37=(a25*a48);
  a18=(a18-a37);
  a37=(a13*a35);
  a18=(a18-a37);
  a37=(a05*a17);
  a18=(a18+a37);
  a33=(a18*a33);
  a12=(a12+a33);
  a47=(a47*a35);
  a46=(a46*a13);
  a47=(a47+a46);
  a25=(a25*a05);
  a47=(a47+a25);
  a48=(a48*a17);
  a47=(a47+a48);
  a22=(a47*a22);
  a12=(a12+a22);
  a22=casadi_sq(a12);
  a10=(a10+a22);
  a10=sqrt(a10);
  a12=(a12/a10);
  a10=(a03*a31);
  a22=(a11*a14);
  a10=(a10+a22);
  a22=(a18*a02);
  a10=(a10-a22);
  a22=(a47*a24);
  a10=(a10-a22);
  a10=(a12*a10);
  a26=(a26-a10);
  if (res[0]!=0) res[0][0]=a26;
  a26=(a29*a02);
  a10=(a16*a31);
  a26=(a26+a10);
  a10=(a19*a24);
  a26=(a26-a10);
  a10=(a27*a14);
  a26=(a26-a10);
  a26=(a21*a26);
  a10=(a03*a02);
  a22=(a18*a31);
  a10=(a10+a22);
  a22=(a11*a24);
  a10=(a10-a22);
  a22=(a47*a14);
  a10=(a10-a22);
  a10=(a12*a10);
  a26=(a26-a10);
  if (res[0]!=0) res[0][1]=a26;
  a16=(a16*a24);
  a19=(a19*a31);
  a16=(a16+a19);
  a29=(a29*a14);
  a16=(a16-a29);
  a27=(a27*a02);
  a16=(a16-a27);
  a21=(a21*a16);
  a11=(a11*a31);
  a18=(a18*a24);
  a11=(a11+a18);
  a03=(a03*a14);
  a11=(a11-a03);
  a47=(a47*a02);
  a11=(a11-a47);
  a12=(a12*a11);
  a21=(a21-a12);
  if (res[0]!=0) res[0][2]=a21;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_quaternion_h_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int val_quaternion_h_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void val_quaternion_h_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void val_quaternion_h_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void val_quaternion_h_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int val_quaternion_h_casadi_n_in(void) { return 8;}

CASADI_SYMBOL_EXPORT casadi_int val_quaternion_h_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real val_quaternion_h_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_quaternion_h_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "position";
    case 2: return "v_n";
    case 3: return "q_b2n_wxyz";
    case 4: return "q_b2m_wxyz";
    case 5: return "omega_ib_b";
    case 6: return "q_m2n_wxyz";
    case 7: return "lag";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_quaternion_h_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_quaternion_h_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    case 4: return casadi_s2;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    case 7: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_quaternion_h_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int val_quaternion_h_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_quaternion_h_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


