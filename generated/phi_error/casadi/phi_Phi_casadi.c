/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) phi_Phi_casadi__ ## ID
#endif

#include <math.h>
#include "../src/phi_math.h"
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
CASADI_SYMBOL_EXPORT void phi_Phi_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int phi_Phi_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int phi_Phi_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {1, 1, 1};
static const casadi_int casadi_s2[3] = {70, 1, 1};

/* phi_Phi_casadi:(lon_lat_height[3],v_n[3],f_n[3],dt)->(out_Phi[70]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52;
  a00=1.;
  if (res[0]!=0) res[0][0]=a00;
  a01=arg[0]? arg[0][2] : 0;
  a02=6378137.;
  a03=6.6943799901413173e-03;
  a04=arg[0]? arg[0][1] : 0;
  a05=sin(a04);
  a06=(a05*a05);
  a07=(a03*a06);
  a07=(a00-a07);
  a08=sqrt(a07);
  a09=(a00/a08);
  a02=(a02*a09);
  a10=(a01+a02);
  a11=(a00/a10);
  a04=cos(a04);
  a12=(a00/a04);
  a13=(a11*a12);
  a14=arg[1]? arg[1][0] : 0;
  a15=(a13*a14);
  a16=(a05*a04);
  a17=(a00/a07);
  a18=(a16*a17);
  a02=(a18*a02);
  a02=(a03*a02);
  a19=(a02*a11);
  a20=(a05*a12);
  a19=(a19-a20);
  a15=(a15*a19);
  a19=arg[3]? arg[3][0] : 0;
  a15=(a15*a19);
  a21=arg[1]? arg[1][1] : 0;
  a22=6.3354393272928204e+06;
  a07=(a07*a08);
  a22=(a22/a07);
  a07=(a01+a22);
  a08=(a07*a07);
  a08=(a21/a08);
  a23=2.0083139970423949e-02;
  a18=(a18*a22);
  a23=(a23*a18);
  a23=(a08*a23);
  a18=(a23*a19);
  a22=(a15*a18);
  a13=(a13*a19);
  a24=1.4584230000000000e-04;
  a25=(a24*a04);
  a26=(a14*a11);
  a27=(a04*a04);
  a27=(a26/a27);
  a10=(a10*a10);
  a10=(a14/a10);
  a02=(a10*a02);
  a28=(a20*a02);
  a27=(a27-a28);
  a28=(a25+a27);
  a29=(a28*a21);
  a24=(a24*a05);
  a30=(a02+a24);
  a31=arg[1]? arg[1][2] : 0;
  a32=(a30*a31);
  a29=(a29+a32);
  a29=(a29*a19);
  a32=(a13*a29);
  a22=(a22+a32);
  a32=5.0000000000000000e-01;
  a22=(a22*a32);
  a22=(a22-a15);
  if (res[0]!=0) res[0][1]=a22;
  a22=(a08*a19);
  a33=(a15*a22);
  a34=(a31*a10);
  a35=(a20*a10);
  a36=(a21*a35);
  a34=(a34-a36);
  a34=(a34*a19);
  a36=(a13*a34);
  a33=(a33+a36);
  a33=(a33*a32);
  a12=(a10*a12);
  a12=(a12*a19);
  a33=(a33-a12);
  if (res[0]!=0) res[0][2]=a33;
  a20=(a20*a11);
  a33=(a21*a20);
  a36=(a31*a11);
  a33=(a33-a36);
  a33=(a33*a19);
  a36=(a13*a33);
  a36=(a36*a32);
  a36=(a13+a36);
  if (res[0]!=0) res[0][3]=a36;
  a36=(a20*a14);
  a24=(a24+a36);
  a37=(a24*a19);
  a38=(a13*a37);
  a07=(a00/a07);
  a39=(a19*a07);
  a15=(a15*a39);
  a38=(a38-a15);
  a38=(a38*a32);
  if (res[0]!=0) res[0][4]=a38;
  a12=(a12*a19);
  a25=(a25+a26);
  a38=(a25*a19);
  a15=(a13*a38);
  a12=(a12+a15);
  a12=(a12*a32);
  a12=(-a12);
  if (res[0]!=0) res[0][5]=a12;
  a12=arg[2]? arg[2][2] : 0;
  a12=(a12*a19);
  a15=(a13*a12);
  a15=(a15*a32);
  a15=(-a15);
  if (res[0]!=0) res[0][6]=a15;
  a15=arg[2]? arg[2][1] : 0;
  a15=(a15*a19);
  a13=(a13*a15);
  a13=(a13*a32);
  if (res[0]!=0) res[0][7]=a13;
  a13=(a00-a18);
  a40=(a18*a18);
  a41=(a31*a23);
  a28=(a28*a14);
  a41=(a41-a28);
  a41=(a41*a19);
  a28=(a39*a41);
  a40=(a40+a28);
  a42=(a40*a32);
  a13=(a13+a42);
  if (res[0]!=0) res[0][8]=a13;
  a13=(a18*a22);
  a42=(a31*a08);
  a43=(a14*a35);
  a42=(a42+a43);
  a42=(a42*a19);
  a43=(a39*a42);
  a13=(a13+a43);
  a13=(a13*a32);
  a13=(a13-a22);
  if (res[0]!=0) res[0][9]=a13;
  a24=(a24+a36);
  a24=(a24*a19);
  a43=(a39*a24);
  a43=(a43*a32);
  a44=(-a43);
  if (res[0]!=0) res[0][10]=a44;
  a44=(a18*a39);
  a31=(a31*a07);
  a31=(a31*a19);
  a45=(a39*a31);
  a44=(a44+a45);
  a44=(a44*a32);
  a44=(a39-a44);
  if (res[0]!=0) res[0][11]=a44;
  a45=(a22*a19);
  a46=(-a45);
  if (res[0]!=0) res[0][12]=a46;
  a46=(a12*a39);
  a47=(a46*a32);
  if (res[0]!=0) res[0][13]=a47;
  a47=arg[2]? arg[2][0] : 0;
  a47=(a47*a19);
  a48=(a39*a47);
  a49=(a48*a32);
  a49=(-a49);
  if (res[0]!=0) res[0][14]=a49;
  a30=(a30*a14);
  a49=4.2053793008804680e-09;
  a50=(a16*a01);
  a51=9.7803253359000006e+00;
  a52=1.8894147482439335e-02;
  a52=(a52*a06);
  a52=(a51+a52);
  a52=(a52*a09);
  a50=(a50*a52);
  a49=(a49*a50);
  a16=(a16*a09);
  a09=3.8637053131731361e-03;
  a50=1.2932555768154467e-05;
  a50=(a50*a06);
  a03=(a03+a50);
  a03=(a03*a17);
  a09=(a09+a03);
  a16=(a16*a09);
  a09=7.3745167729419953e-14;
  a03=(a01*a01);
  a09=(a09*a03);
  a09=(a00+a09);
  a03=1.5678559428873979e-07;
  a17=2.0136051943431768e+00;
  a50=1.3411242658989924e-02;
  a50=(a50*a06);
  a17=(a17-a50);
  a17=(a01*a17);
  a03=(a03*a17);
  a09=(a09-a03);
  a16=(a16*a09);
  a51=(a51*a16);
  a49=(a49+a51);
  a30=(a30+a49);
  a23=(a21*a23);
  a30=(a30+a23);
  a30=(a30*a19);
  a23=(a19*a30);
  a23=(a23*a32);
  a23=(-a23);
  if (res[0]!=0) res[0][15]=a23;
  a14=(a14*a10);
  a23=1.4749033545883991e-13;
  a23=(a23*a01);
  a01=2.1026896504402340e-09;
  a01=(a01*a06);
  a23=(a23+a01);
  a01=3.1570428705798834e-07;
  a23=(a23-a01);
  a23=(a23*a52);
  a14=(a14+a23);
  a08=(a21*a08);
  a14=(a14+a08);
  a14=(a14*a19);
  a08=(a19*a14);
  a23=(a08*a32);
  a23=(a00-a23);
  if (res[0]!=0) res[0][16]=a23;
  a25=(a26+a25);
  a25=(a25*a19);
  a23=(a19*a25);
  a23=(a23*a32);
  if (res[0]!=0) res[0][17]=a23;
  a23=2.;
  a21=(a21*a07);
  a23=(a23*a21);
  a23=(a23*a19);
  a07=(a19*a23);
  a07=(a07*a32);
  if (res[0]!=0) res[0][18]=a07;
  if (res[0]!=0) res[0][19]=a19;
  a07=(a19*a15);
  a07=(a07*a32);
  a07=(-a07);
  if (res[0]!=0) res[0][20]=a07;
  a07=(a19*a47);
  a07=(a07*a32);
  if (res[0]!=0) res[0][21]=a07;
  a07=(a33*a29);
  a52=(a29*a18);
  a07=(a07-a52);
  a52=(a37*a41);
  a07=(a07+a52);
  a52=(a38*a30);
  a07=(a07+a52);
  a52=7.2921149999999999e-05;
  a05=(a52*a05);
  a02=(a02+a05);
  a02=(a02*a19);
  a01=(a12*a02);
  a07=(a07+a01);
  a52=(a52*a04);
  a27=(a52+a27);
  a27=(a27*a19);
  a04=(a15*a27);
  a07=(a07+a04);
  a07=(a07*a32);
  a07=(a29+a07);
  if (res[0]!=0) res[0][22]=a07;
  a07=(a33*a34);
  a04=(a29*a22);
  a07=(a07-a04);
  a04=(a37*a42);
  a07=(a07+a04);
  a04=(a38*a14);
  a07=(a07+a04);
  a10=(a10*a19);
  a04=(a12*a10);
  a07=(a07+a04);
  a35=(a35*a19);
  a04=(a15*a35);
  a07=(a07-a04);
  a07=(a07*a32);
  a07=(a34+a07);
  if (res[0]!=0) res[0][23]=a07;
  a07=(a00+a33);
  a04=(a33*a33);
  a01=(a37*a24);
  a04=(a04-a01);
  a06=(a38*a25);
  a04=(a04-a06);
  a11=(a19*a11);
  a49=(a12*a11);
  a04=(a04-a49);
  a20=(a20*a19);
  a51=(a15*a20);
  a04=(a04+a51);
  a04=(a04*a32);
  a07=(a07+a04);
  if (res[0]!=0) res[0][24]=a07;
  a07=(a29*a39);
  a04=(a33*a37);
  a07=(a07+a04);
  a04=(a37*a31);
  a07=(a07-a04);
  a04=(a38*a23);
  a07=(a07-a04);
  a07=(a07*a32);
  a07=(a37+a07);
  if (res[0]!=0) res[0][25]=a07;
  a07=(a25*a33);
  a21=(a21*a19);
  a04=(a37*a21);
  a04=(a07+a04);
  a04=(a04*a32);
  a04=(a04+a38);
  a04=(-a04);
  if (res[0]!=0) res[0][26]=a04;
  a04=(a37*a12);
  a16=(a38*a15);
  a04=(a04+a16);
  a36=(a36+a05);
  a36=(a36*a19);
  a05=(a12*a36);
  a04=(a04+a05);
  a26=(a26+a52);
  a26=(a26*a19);
  a52=(a15*a26);
  a04=(a04+a52);
  a04=(a04*a32);
  if (res[0]!=0) res[0][27]=a04;
  a04=(a21*a15);
  a16=(a33*a12);
  a09=(a38*a47);
  a16=(a16+a09);
  a16=(a04-a16);
  a16=(a16*a32);
  a16=(a16-a12);
  if (res[0]!=0) res[0][28]=a16;
  a16=(a33*a15);
  a09=(a37*a47);
  a16=(a16-a09);
  a09=(a12*a21);
  a16=(a16+a09);
  a16=(a16*a32);
  a16=(a15+a16);
  if (res[0]!=0) res[0][29]=a16;
  a16=(a21*a30);
  a09=(a41*a18);
  a03=(a24*a29);
  a09=(a09+a03);
  a03=(a31*a41);
  a09=(a09+a03);
  a16=(a16-a09);
  a09=(a12*a18);
  a16=(a16+a09);
  a09=(a47*a27);
  a16=(a16-a09);
  a16=(a16*a32);
  a16=(a41+a16);
  if (res[0]!=0) res[0][30]=a16;
  a16=(a21*a14);
  a09=(a41*a22);
  a03=(a24*a34);
  a09=(a09+a03);
  a03=(a31*a42);
  a09=(a09+a03);
  a16=(a16-a09);
  a09=(a12*a22);
  a16=(a16+a09);
  a09=(a47*a35);
  a16=(a16+a09);
  a16=(a16*a32);
  a16=(a42+a16);
  if (res[0]!=0) res[0][31]=a16;
  a16=(a31*a24);
  a09=(a24*a33);
  a16=(a16-a09);
  a09=(a21*a25);
  a16=(a16-a09);
  a09=(a47*a20);
  a16=(a16-a09);
  a16=(a16*a32);
  a16=(a16-a24);
  if (res[0]!=0) res[0][32]=a16;
  a16=(a00-a31);
  a28=(a28-a01);
  a01=(a31*a31);
  a28=(a28+a01);
  a01=(a21*a23);
  a28=(a28-a01);
  a28=(a28-a46);
  a28=(a28*a32);
  a16=(a16+a28);
  if (res[0]!=0) res[0][33]=a16;
  a16=(a42*a19);
  a28=(a25*a37);
  a16=(a16+a28);
  a09=(a31*a21);
  a16=(a16+a09);
  a16=(a16*a32);
  a16=(a16-a21);
  if (res[0]!=0) res[0][34]=a16;
  a16=(a31*a12);
  a04=(a04-a16);
  a16=(a47*a26);
  a04=(a04-a16);
  a04=(a04*a32);
  a04=(a12+a04);
  if (res[0]!=0) res[0][35]=a04;
  a04=(a24*a12);
  a16=(a21*a47);
  a04=(a04-a16);
  a04=(a04+a05);
  a04=(a04-a16);
  a04=(a04*a32);
  if (res[0]!=0) res[0][36]=a04;
  a04=(a31*a47);
  a05=(a24*a15);
  a04=(a04-a05);
  a05=(a12*a26);
  a04=(a04-a05);
  a04=(a04*a32);
  a04=(a04-a47);
  if (res[0]!=0) res[0][37]=a04;
  a04=(a30*a18);
  a05=(a25*a29);
  a04=(a04+a05);
  a41=(a23*a41);
  a04=(a04+a41);
  a41=(a15*a18);
  a04=(a04-a41);
  a41=(a47*a02);
  a04=(a04-a41);
  a04=(a04*a32);
  a04=(a04-a30);
  if (res[0]!=0) res[0][38]=a04;
  a04=(a30*a22);
  a41=(a25*a34);
  a04=(a04+a41);
  a42=(a23*a42);
  a04=(a04+a42);
  a42=(a15*a22);
  a04=(a04-a42);
  a42=(a47*a10);
  a04=(a04-a42);
  a04=(a04*a32);
  a04=(a04-a14);
  if (res[0]!=0) res[0][39]=a04;
  a24=(a23*a24);
  a07=(a07-a24);
  a24=(a47*a11);
  a07=(a07+a24);
  a07=(a07*a32);
  a07=(a25+a07);
  if (res[0]!=0) res[0][40]=a07;
  a30=(a30*a39);
  a28=(a28-a30);
  a31=(a23*a31);
  a28=(a28-a31);
  a31=(a15*a39);
  a28=(a28+a31);
  a28=(a28*a32);
  a28=(a23+a28);
  if (res[0]!=0) res[0][41]=a28;
  a08=(a08+a06);
  a08=(a08+a01);
  a08=(a08*a32);
  a08=(a00-a08);
  if (res[0]!=0) res[0][42]=a08;
  a08=(a23*a12);
  a01=(a47*a36);
  a08=(a08-a01);
  a08=(a08*a32);
  a08=(a08-a15);
  if (res[0]!=0) res[0][43]=a08;
  a08=(a25*a12);
  a01=(a15*a36);
  a08=(a08+a01);
  a08=(a08*a32);
  a08=(a47-a08);
  if (res[0]!=0) res[0][44]=a08;
  a25=(a25*a15);
  a23=(a23*a47);
  a25=(a25-a23);
  a25=(a25+a52);
  a25=(a25-a16);
  a25=(a25*a32);
  if (res[0]!=0) res[0][45]=a25;
  a25=(a36*a02);
  a40=(a40+a25);
  a25=(a26*a27);
  a40=(a40+a25);
  a40=(a40*a32);
  a40=(a18-a40);
  if (res[0]!=0) res[0][46]=a40;
  a13=(-a13);
  if (res[0]!=0) res[0][47]=a13;
  if (res[0]!=0) res[0][48]=a43;
  a44=(-a44);
  if (res[0]!=0) res[0][49]=a44;
  if (res[0]!=0) res[0][50]=a45;
  a45=(a36*a36);
  a46=(a46+a45);
  a44=(a26*a26);
  a46=(a46+a44);
  a46=(a46*a32);
  a46=(a00-a46);
  if (res[0]!=0) res[0][51]=a46;
  a46=(a21*a26);
  a46=(a46*a32);
  a13=(a36-a46);
  if (res[0]!=0) res[0][52]=a13;
  a13=(a21*a36);
  a48=(a48-a13);
  a48=(a48*a32);
  a48=(a48-a26);
  if (res[0]!=0) res[0][53]=a48;
  a48=(a02*a18);
  a40=(a11*a29);
  a48=(a48+a40);
  a40=(a36*a18);
  a48=(a48-a40);
  a40=(a21*a27);
  a48=(a48-a40);
  a48=(a48*a32);
  a48=(a48-a02);
  if (res[0]!=0) res[0][54]=a48;
  a48=(a02*a22);
  a40=(a11*a34);
  a48=(a48+a40);
  a40=(a36*a22);
  a48=(a48-a40);
  a40=(a21*a35);
  a48=(a48+a40);
  a48=(a48*a32);
  a48=(a48-a10);
  if (res[0]!=0) res[0][55]=a48;
  a48=(a11*a33);
  a40=(a21*a20);
  a48=(a48-a40);
  a48=(a48*a32);
  a48=(a11+a48);
  if (res[0]!=0) res[0][56]=a48;
  a48=(a11*a37);
  a40=(a02*a39);
  a48=(a48-a40);
  a48=(a48+a43);
  a48=(a48*a32);
  if (res[0]!=0) res[0][57]=a48;
  a19=(a10*a19);
  a38=(a11*a38);
  a19=(a19+a38);
  a19=(a19*a32);
  a19=(-a19);
  if (res[0]!=0) res[0][58]=a19;
  a46=(a36+a46);
  a46=(-a46);
  if (res[0]!=0) res[0][59]=a46;
  a49=(a49+a45);
  a45=(a21*a21);
  a49=(a49+a45);
  a49=(a49*a32);
  a49=(a00-a49);
  if (res[0]!=0) res[0][60]=a49;
  a15=(a11*a15);
  a49=(a26*a36);
  a15=(a15+a49);
  a15=(a15*a32);
  a15=(a15-a21);
  if (res[0]!=0) res[0][61]=a15;
  a29=(a20*a29);
  a15=(a27*a18);
  a29=(a29-a15);
  a18=(a26*a18);
  a29=(a29+a18);
  a02=(a21*a02);
  a29=(a29-a02);
  a29=(a29*a32);
  a29=(a27+a29);
  if (res[0]!=0) res[0][62]=a29;
  a34=(a20*a34);
  a29=(a27*a22);
  a34=(a34-a29);
  a22=(a26*a22);
  a34=(a34+a22);
  a10=(a21*a10);
  a34=(a34-a10);
  a34=(a34*a32);
  a34=(a34-a35);
  if (res[0]!=0) res[0][63]=a34;
  a33=(a20*a33);
  a34=(a21*a11);
  a33=(a33+a34);
  a33=(a33*a32);
  a33=(a20+a33);
  if (res[0]!=0) res[0][64]=a33;
  a27=(a27*a39);
  a37=(a20*a37);
  a27=(a27+a37);
  a39=(a26*a39);
  a27=(a27-a39);
  a27=(a27*a32);
  if (res[0]!=0) res[0][65]=a27;
  a36=(a36*a11);
  a36=(-a36);
  if (res[0]!=0) res[0][66]=a36;
  a13=(a13*a32);
  a26=(a26-a13);
  if (res[0]!=0) res[0][67]=a26;
  a20=(a20*a12);
  a49=(a49-a20);
  a49=(a49*a32);
  a21=(a21+a49);
  if (res[0]!=0) res[0][68]=a21;
  a51=(a51-a44);
  a51=(a51-a45);
  a51=(a51*a32);
  a00=(a00+a51);
  if (res[0]!=0) res[0][69]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int phi_Phi_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int phi_Phi_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void phi_Phi_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void phi_Phi_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void phi_Phi_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int phi_Phi_casadi_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int phi_Phi_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real phi_Phi_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* phi_Phi_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    case 2: return "f_n";
    case 3: return "dt";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* phi_Phi_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Phi";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* phi_Phi_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s0;
    case 3: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* phi_Phi_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int phi_Phi_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int phi_Phi_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


