/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_quaternion_h_casadi__ ## ID
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
#define casadi_s4 CASADI_PREFIX(s4)

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
CASADI_SYMBOL_EXPORT void vas_quaternion_h_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {46, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {4, 1, 1};
static const casadi_int casadi_s3[3] = {1, 1, 1};
static const casadi_int casadi_s4[3] = {6, 1, 1};

/* vas_quaternion_h_casadi:(x[46],lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],q_m2n_wxyz[4],lag,flexure[3],flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72;
  a00=2.;
  a01=arg[6]? arg[6][0] : 0;
  a02=5.0000000000000000e-01;
  a03=1.0000000000000001e-30;
  a04=arg[7]? arg[7][0] : 0;
  a05=(a04*a04);
  a06=arg[2]? arg[2][1] : 0;
  a07=arg[1]? arg[1][2] : 0;
  a08=6378137.;
  a09=1.;
  a10=6.6943799901413173e-03;
  a11=arg[1]? arg[1][0] : 0;
  a12=sin(a11);
  a13=(a12*a12);
  a10=(a10*a13);
  a10=(a09-a10);
  a13=sqrt(a10);
  a08=(a08/a13);
  a08=(a07+a08);
  a06=(a06/a08);
  a11=cos(a11);
  a08=(a12/a11);
  a08=(a06*a08);
  a14=7.2921149999999999e-05;
  a12=(a14*a12);
  a08=(a08+a12);
  a12=arg[5]? arg[5][0] : 0;
  a15=arg[10]? arg[10][0] : 0;
  a16=(a09-a15);
  a16=(a12*a16);
  a17=arg[9]? arg[9][0] : 0;
  a18=arg[4]? arg[4][1] : 0;
  a19=(a18*a18);
  a20=arg[4]? arg[4][2] : 0;
  a21=(a20*a20);
  a22=(a19-a21);
  a23=arg[4]? arg[4][3] : 0;
  a24=(a23*a23);
  a22=(a22-a24);
  a25=arg[4]? arg[4][0] : 0;
  a26=(a25*a25);
  a22=(a22+a26);
  a27=(a17*a22);
  a16=(a16-a27);
  a28=arg[9]? arg[9][1] : 0;
  a29=(a00*a25);
  a30=(a29*a23);
  a31=(a00*a20);
  a32=(a31*a18);
  a33=(a30+a32);
  a34=(a28*a33);
  a16=(a16-a34);
  a35=arg[9]? arg[9][2] : 0;
  a36=(a00*a18);
  a36=(a36*a23);
  a37=(a29*a20);
  a38=(a36-a37);
  a39=(a35*a38);
  a16=(a16-a39);
  a40=arg[11]? arg[11][0] : 0;
  a41=arg[5]? arg[5][1] : 0;
  a42=(a40*a41);
  a16=(a16-a42);
  a42=arg[11]? arg[11][1] : 0;
  a43=arg[5]? arg[5][2] : 0;
  a44=(a42*a43);
  a16=(a16-a44);
  a44=arg[3]? arg[3][1] : 0;
  a45=(a00*a44);
  a46=arg[3]? arg[3][3] : 0;
  a47=(a45*a46);
  a48=arg[3]? arg[3][0] : 0;
  a49=(a00*a48);
  a50=arg[3]? arg[3][2] : 0;
  a51=(a49*a50);
  a52=(a47-a51);
  a52=(a16*a52);
  a52=(a08+a52);
  a53=arg[10]? arg[10][1] : 0;
  a54=(a09-a53);
  a54=(a41*a54);
  a32=(a32-a30);
  a30=(a17*a32);
  a54=(a54-a30);
  a26=(a26-a19);
  a19=(a26+a21);
  a19=(a19-a24);
  a55=(a28*a19);
  a54=(a54-a55);
  a29=(a29*a18);
  a31=(a31*a23);
  a56=(a29+a31);
  a57=(a35*a56);
  a54=(a54-a57);
  a58=arg[11]? arg[11][2] : 0;
  a59=(a58*a12);
  a54=(a54-a59);
  a59=arg[11]? arg[11][3] : 0;
  a60=(a59*a43);
  a54=(a54-a60);
  a60=(a49*a44);
  a61=(a00*a46);
  a61=(a61*a50);
  a62=(a60+a61);
  a62=(a54*a62);
  a52=(a52+a62);
  a62=arg[10]? arg[10][2] : 0;
  a63=(a09-a62);
  a63=(a43*a63);
  a37=(a37+a36);
  a36=(a17*a37);
  a63=(a63-a36);
  a31=(a31-a29);
  a29=(a28*a31);
  a63=(a63-a29);
  a26=(a26-a21);
  a26=(a26+a24);
  a24=(a35*a26);
  a63=(a63-a24);
  a21=arg[11]? arg[11][4] : 0;
  a64=(a21*a12);
  a63=(a63-a64);
  a64=arg[11]? arg[11][5] : 0;
  a65=(a64*a41);
  a63=(a63-a65);
  a65=(a46*a46);
  a66=(a50*a50);
  a67=(a65-a66);
  a68=(a48*a48);
  a69=(a44*a44);
  a70=(a68-a69);
  a67=(a67+a70);
  a67=(a63*a67);
  a52=(a52+a67);
  a67=(a52*a52);
  a67=(a05*a67);
  a67=(a03+a67);
  a71=arg[2]? arg[2][0] : 0;
  a72=6.3354393272928204e+06;
  a10=(a10*a13);
  a72=(a72/a10);
  a07=(a07+a72);
  a71=(a71/a07);
  a49=(a49*a46);
  a45=(a45*a50);
  a07=(a49+a45);
  a07=(a16*a07);
  a07=(a71+a07);
  a70=(a66+a70);
  a70=(a70-a65);
  a70=(a54*a70);
  a07=(a07+a70);
  a61=(a61-a60);
  a61=(a63*a61);
  a07=(a07+a61);
  a61=(a07*a07);
  a61=(a05*a61);
  a67=(a67+a61);
  a68=(a68-a66);
  a68=(a68+a69);
  a68=(a68-a65);
  a16=(a16*a68);
  a14=(a14*a11);
  a06=(a06+a14);
  a16=(a16-a06);
  a45=(a45-a49);
  a54=(a54*a45);
  a16=(a16+a54);
  a51=(a51+a47);
  a63=(a63*a51);
  a16=(a16+a63);
  a63=(a16*a16);
  a05=(a05*a63);
  a67=(a67+a05);
  a67=sqrt(a67);
  a05=(a02*a67);
  a63=cos(a05);
  a51=2.5000000000000000e-01;
  a47=arg[8]? arg[8][0] : 0;
  a54=(a47*a47);
  a54=(a51*a54);
  a54=(a09+a54);
  a45=arg[8]? arg[8][1] : 0;
  a49=(a45*a45);
  a49=(a51*a49);
  a54=(a54+a49);
  a49=arg[8]? arg[8][2] : 0;
  a14=(a49*a49);
  a51=(a51*a14);
  a54=(a54+a51);
  a54=sqrt(a54);
  a54=(a09/a54);
  a51=(a25*a54);
  a14=(a02*a54);
  a47=(a14*a47);
  a11=(a18*a47);
  a51=(a51-a11);
  a45=(a14*a45);
  a11=(a20*a45);
  a51=(a51-a11);
  a14=(a14*a49);
  a49=(a23*a14);
  a51=(a51-a49);
  a49=(a48*a51);
  a11=(a25*a47);
  a68=(a18*a54);
  a11=(a11+a68);
  a68=(a23*a45);
  a11=(a11+a68);
  a68=(a20*a14);
  a11=(a11-a68);
  a68=(a44*a11);
  a49=(a49+a68);
  a68=(a25*a45);
  a65=(a18*a14);
  a68=(a68+a65);
  a65=(a20*a54);
  a68=(a68+a65);
  a65=(a23*a47);
  a68=(a68-a65);
  a65=(a50*a68);
  a49=(a49+a65);
  a25=(a25*a14);
  a20=(a20*a47);
  a25=(a25+a20);
  a23=(a23*a54);
  a25=(a25+a23);
  a18=(a18*a45);
  a25=(a25-a18);
  a18=(a46*a25);
  a49=(a49+a18);
  a18=(a63*a49);
  a05=sin(a05);
  a05=(a04*a05);
  a05=(a05/a67);
  a16=(a05*a16);
  a67=(a44*a51);
  a45=(a46*a68);
  a67=(a67+a45);
  a45=(a48*a11);
  a67=(a67-a45);
  a45=(a50*a25);
  a67=(a67-a45);
  a45=(a16*a67);
  a18=(a18+a45);
  a07=(a05*a07);
  a45=(a44*a25);
  a23=(a50*a51);
  a45=(a45+a23);
  a23=(a48*a68);
  a45=(a45-a23);
  a23=(a46*a11);
  a45=(a45-a23);
  a23=(a07*a45);
  a18=(a18+a23);
  a05=(a05*a52);
  a52=(a50*a11);
  a23=(a46*a51);
  a52=(a52+a23);
  a23=(a48*a25);
  a52=(a52-a23);
  a23=(a44*a68);
  a52=(a52-a23);
  a23=(a05*a52);
  a18=(a18+a23);
  a23=(a01*a18);
  a54=arg[6]? arg[6][1] : 0;
  a20=(a63*a67);
  a47=(a05*a45);
  a20=(a20+a47);
  a47=(a16*a49);
  a20=(a20-a47);
  a47=(a07*a52);
  a20=(a20-a47);
  a47=(a54*a20);
  a23=(a23+a47);
  a47=arg[6]? arg[6][2] : 0;
  a14=(a63*a45);
  a65=(a16*a52);
  a14=(a14+a65);
  a65=(a07*a49);
  a14=(a14-a65);
  a65=(a05*a67);
  a14=(a14-a65);
  a65=(a47*a14);
  a23=(a23+a65);
  a65=arg[6]? arg[6][3] : 0;
  a63=(a63*a52);
  a07=(a07*a67);
  a63=(a63+a07);
  a16=(a16*a45);
  a63=(a63-a16);
  a05=(a05*a49);
  a63=(a63-a05);
  a05=(a65*a63);
  a23=(a23+a05);
  a05=0.;
  a23=(a23<a05);
  a49=(!a23);
  a49=(a49-a23);
  a49=(a00*a49);
  a23=(a01*a20);
  a16=(a47*a63);
  a23=(a23+a16);
  a16=(a54*a18);
  a23=(a23-a16);
  a16=(a65*a14);
  a23=(a23-a16);
  a23=(a49*a23);
  a16=arg[0]? arg[0][15] : 0;
  a04=(a04-a16);
  a16=(a04*a04);
  a45=arg[0]? arg[0][7] : 0;
  a45=(a45+a41);
  a41=arg[0]? arg[0][31] : 0;
  a41=(a41-a40);
  a41=(a45*a41);
  a40=arg[0]? arg[0][8] : 0;
  a40=(a40+a43);
  a43=arg[0]? arg[0][32] : 0;
  a43=(a43-a42);
  a43=(a40*a43);
  a41=(a41+a43);
  a43=arg[0]? arg[0][6] : 0;
  a43=(a43+a12);
  a12=arg[0]? arg[0][25] : 0;
  a12=(a09+a12);
  a12=(a12-a15);
  a12=(a43*a12);
  a41=(a41+a12);
  a12=arg[0]? arg[0][22] : 0;
  a15=arg[0]? arg[0][13] : 0;
  a42=(a35*a15);
  a12=(a12+a42);
  a42=arg[0]? arg[0][14] : 0;
  a07=(a28*a42);
  a12=(a12-a07);
  a22=(a12*a22);
  a41=(a41+a22);
  a22=arg[0]? arg[0][23] : 0;
  a07=(a17*a42);
  a22=(a22+a07);
  a07=arg[0]? arg[0][12] : 0;
  a35=(a35*a07);
  a22=(a22-a35);
  a33=(a22*a33);
  a41=(a41+a33);
  a33=arg[0]? arg[0][24] : 0;
  a28=(a28*a07);
  a33=(a33+a28);
  a17=(a17*a15);
  a33=(a33-a17);
  a38=(a33*a38);
  a41=(a41+a38);
  a41=(a41-a27);
  a41=(a41-a34);
  a41=(a41-a39);
  a39=arg[0]? arg[0][2] : 0;
  a34=(a39*a39);
  a34=(a03+a34);
  a27=arg[0]? arg[0][1] : 0;
  a38=(a27*a27);
  a34=(a34+a38);
  a38=arg[0]? arg[0][0] : 0;
  a17=(a38*a38);
  a34=(a34+a17);
  a34=sqrt(a34);
  a17=(a02*a34);
  a28=sin(a17);
  a28=(a28/a34);
  a38=(a28*a38);
  a34=(a48*a38);
  a17=cos(a17);
  a35=(a44*a17);
  a34=(a34+a35);
  a27=(a28*a27);
  a35=(a46*a27);
  a34=(a34+a35);
  a28=(a28*a39);
  a39=(a50*a28);
  a34=(a34-a39);
  a39=(a00*a34);
  a35=(a48*a28);
  a67=(a50*a38);
  a35=(a35+a67);
  a67=(a46*a17);
  a35=(a35+a67);
  a67=(a44*a27);
  a35=(a35-a67);
  a67=(a39*a35);
  a52=(a48*a17);
  a69=(a44*a38);
  a52=(a52-a69);
  a69=(a50*a27);
  a52=(a52-a69);
  a69=(a46*a28);
  a52=(a52-a69);
  a69=(a00*a52);
  a48=(a48*a27);
  a44=(a44*a28);
  a48=(a48+a44);
  a50=(a50*a17);
  a48=(a48+a50);
  a46=(a46*a38);
  a48=(a48-a46);
  a46=(a69*a48);
  a38=(a67-a46);
  a38=(a41*a38);
  a08=(a08+a38);
  a38=arg[0]? arg[0][26] : 0;
  a38=(a09+a38);
  a38=(a38-a53);
  a38=(a45*a38);
  a53=arg[0]? arg[0][34] : 0;
  a53=(a53-a59);
  a53=(a40*a53);
  a38=(a38+a53);
  a53=arg[0]? arg[0][33] : 0;
  a53=(a53-a58);
  a53=(a43*a53);
  a38=(a38+a53);
  a32=(a12*a32);
  a38=(a38+a32);
  a19=(a22*a19);
  a38=(a38+a19);
  a56=(a33*a56);
  a38=(a38+a56);
  a38=(a38-a30);
  a38=(a38-a55);
  a38=(a38-a57);
  a57=(a69*a34);
  a55=(a00*a35);
  a55=(a55*a48);
  a30=(a57+a55);
  a30=(a38*a30);
  a08=(a08+a30);
  a30=arg[0]? arg[0][36] : 0;
  a30=(a30-a64);
  a45=(a45*a30);
  a30=arg[0]? arg[0][27] : 0;
  a09=(a09+a30);
  a09=(a09-a62);
  a40=(a40*a09);
  a45=(a45+a40);
  a40=arg[0]? arg[0][35] : 0;
  a40=(a40-a21);
  a43=(a43*a40);
  a45=(a45+a43);
  a12=(a12*a37);
  a45=(a45+a12);
  a22=(a22*a31);
  a45=(a45+a22);
  a33=(a33*a26);
  a45=(a45+a33);
  a45=(a45-a36);
  a45=(a45-a29);
  a45=(a45-a24);
  a24=(a35*a35);
  a29=(a48*a48);
  a36=(a24-a29);
  a33=(a52*a52);
  a26=(a34*a34);
  a22=(a33-a26);
  a36=(a36+a22);
  a36=(a45*a36);
  a08=(a08+a36);
  a36=(a08*a08);
  a36=(a16*a36);
  a36=(a03+a36);
  a69=(a69*a35);
  a39=(a39*a48);
  a31=(a69+a39);
  a31=(a41*a31);
  a71=(a71+a31);
  a22=(a29+a22);
  a22=(a22-a24);
  a22=(a38*a22);
  a71=(a71+a22);
  a55=(a55-a57);
  a55=(a45*a55);
  a71=(a71+a55);
  a55=(a71*a71);
  a55=(a16*a55);
  a36=(a36+a55);
  a33=(a33-a29);
  a33=(a33+a26);
  a33=(a33-a24);
  a41=(a41*a33);
  a41=(a41-a06);
  a39=(a39-a69);
  a38=(a38*a39);
  a41=(a41+a38);
  a46=(a46+a67);
  a45=(a45*a46);
  a41=(a41+a45);
  a45=(a41*a41);
  a16=(a16*a45);
  a36=(a36+a16);
  a36=sqrt(a36);
  a16=(a02*a36);
  a45=cos(a16);
  a46=arg[0]? arg[0][19] : 0;
  a07=(a07-a46);
  a46=(a07*a07);
  a03=(a03+a46);
  a46=arg[0]? arg[0][20] : 0;
  a15=(a15-a46);
  a46=(a15*a15);
  a03=(a03+a46);
  a46=arg[0]? arg[0][21] : 0;
  a42=(a42-a46);
  a46=(a42*a42);
  a03=(a03+a46);
  a03=sqrt(a03);
  a02=(a02*a03);
  a46=cos(a02);
  a67=(a51*a46);
  a02=sin(a02);
  a02=(a02/a03);
  a07=(a07*a02);
  a03=(a11*a07);
  a67=(a67-a03);
  a15=(a15*a02);
  a03=(a68*a15);
  a67=(a67-a03);
  a42=(a42*a02);
  a02=(a25*a42);
  a67=(a67-a02);
  a02=(a67*a52);
  a03=(a51*a07);
  a38=(a11*a46);
  a03=(a03+a38);
  a38=(a25*a15);
  a03=(a03+a38);
  a38=(a68*a42);
  a03=(a03-a38);
  a38=(a03*a34);
  a02=(a02+a38);
  a38=(a51*a15);
  a39=(a11*a42);
  a38=(a38+a39);
  a39=(a68*a46);
  a38=(a38+a39);
  a39=(a25*a07);
  a38=(a38-a39);
  a39=(a38*a48);
  a02=(a02+a39);
  a51=(a51*a42);
  a68=(a68*a07);
  a51=(a51+a68);
  a25=(a25*a46);
  a51=(a51+a25);
  a11=(a11*a15);
  a51=(a51-a11);
  a11=(a51*a35);
  a02=(a02+a11);
  a11=(a45*a02);
  a16=sin(a16);
  a04=(a04*a16);
  a04=(a04/a36);
  a41=(a04*a41);
  a36=(a67*a34);
  a16=(a38*a35);
  a36=(a36+a16);
  a16=(a03*a52);
  a36=(a36-a16);
  a16=(a51*a48);
  a36=(a36-a16);
  a16=(a41*a36);
  a11=(a11+a16);
  a71=(a04*a71);
  a16=(a67*a48);
  a15=(a51*a34);
  a16=(a16+a15);
  a15=(a03*a35);
  a16=(a16-a15);
  a15=(a38*a52);
  a16=(a16-a15);
  a15=(a71*a16);
  a11=(a11+a15);
  a04=(a04*a08);
  a67=(a67*a35);
  a03=(a03*a48);
  a67=(a67+a03);
  a38=(a38*a34);
  a67=(a67-a38);
  a51=(a51*a52);
  a67=(a67-a51);
  a51=(a04*a67);
  a11=(a11+a51);
  a51=(a01*a11);
  a52=(a45*a36);
  a38=(a04*a16);
  a52=(a52+a38);
  a38=(a41*a02);
  a52=(a52-a38);
  a38=(a71*a67);
  a52=(a52-a38);
  a38=(a54*a52);
  a51=(a51+a38);
  a38=(a45*a16);
  a34=(a41*a67);
  a38=(a38+a34);
  a34=(a71*a02);
  a38=(a38-a34);
  a34=(a04*a36);
  a38=(a38-a34);
  a34=(a47*a38);
  a51=(a51+a34);
  a45=(a45*a67);
  a71=(a71*a36);
  a45=(a45+a71);
  a41=(a41*a16);
  a45=(a45-a41);
  a04=(a04*a02);
  a45=(a45-a04);
  a04=(a65*a45);
  a51=(a51+a04);
  a51=(a51<a05);
  a05=(!a51);
  a05=(a05-a51);
  a00=(a00*a05);
  a05=(a01*a52);
  a51=(a47*a45);
  a05=(a05+a51);
  a51=(a54*a11);
  a05=(a05-a51);
  a51=(a65*a38);
  a05=(a05-a51);
  a05=(a00*a05);
  a23=(a23-a05);
  if (res[0]!=0) res[0][0]=a23;
  a23=(a01*a14);
  a05=(a65*a20);
  a23=(a23+a05);
  a05=(a54*a63);
  a23=(a23-a05);
  a05=(a47*a18);
  a23=(a23-a05);
  a23=(a49*a23);
  a05=(a01*a38);
  a51=(a65*a52);
  a05=(a05+a51);
  a51=(a54*a45);
  a05=(a05-a51);
  a51=(a47*a11);
  a05=(a05-a51);
  a05=(a00*a05);
  a23=(a23-a05);
  if (res[0]!=0) res[0][1]=a23;
  a63=(a01*a63);
  a14=(a54*a14);
  a63=(a63+a14);
  a20=(a47*a20);
  a63=(a63-a20);
  a18=(a65*a18);
  a63=(a63-a18);
  a49=(a49*a63);
  a01=(a01*a45);
  a54=(a54*a38);
  a01=(a01+a54);
  a47=(a47*a52);
  a01=(a01-a47);
  a65=(a65*a11);
  a01=(a01-a65);
  a00=(a00*a01);
  a49=(a49-a00);
  if (res[0]!=0) res[0][2]=a49;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_quaternion_h_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_quaternion_h_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_quaternion_h_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_quaternion_h_casadi_n_in(void) { return 12;}

CASADI_SYMBOL_EXPORT casadi_int vas_quaternion_h_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_quaternion_h_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_quaternion_h_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "lat_lon_height";
    case 2: return "v_n";
    case 3: return "q_b2n_wxyz";
    case 4: return "q_b2m_wxyz";
    case 5: return "omega_ib_b";
    case 6: return "q_m2n_wxyz";
    case 7: return "lag";
    case 8: return "flexure";
    case 9: return "flexure_rate";
    case 10: return "gyro_scale";
    case 11: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_quaternion_h_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_quaternion_h_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    case 4: return casadi_s2;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    case 7: return casadi_s3;
    case 8: return casadi_s1;
    case 9: return casadi_s1;
    case 10: return casadi_s1;
    case 11: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_quaternion_h_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


