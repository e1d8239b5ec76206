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
  a02=(a01+a02);
  a10=(a00/a02);
  a04=cos(a04);
  a11=(a00/a04);
  a12=(a10*a11);
  a13=arg[1]? arg[1][0] : 0;
  a14=(a12*a13);
  a15=4.2697672707179969e+04;
  a16=(a05*a04);
  a17=(a07*a08);
  a17=(a00/a17);
  a18=(a16*a17);
  a19=(a18*a10);
  a19=(a15*a19);
  a20=(a05*a11);
  a19=(a19-a20);
  a14=(a14*a19);
  a19=arg[3]? arg[3][0] : 0;
  a14=(a14*a19);
  a21=arg[1]? arg[1][1] : 0;
  a22=6.3354393272928204e+06;
  a22=(a22*a17);
  a22=(a01+a22);
  a17=(a22*a22);
  a17=(a00/a17);
  a23=(a21*a17);
  a24=1.2723551478415026e+05;
  a25=(a07*a07);
  a25=(a25*a08);
  a25=(a00/a25);
  a08=(a16*a25);
  a08=(a24*a08);
  a26=(a23*a08);
  a26=(a26*a19);
  a27=(a14*a26);
  a12=(a12*a19);
  a28=1.4584230000000000e-04;
  a29=(a28*a04);
  a30=(a13*a10);
  a31=(a04*a04);
  a31=(a30/a31);
  a15=(a15*a18);
  a02=(a02*a02);
  a02=(a00/a02);
  a18=(a13*a02);
  a32=(a20*a18);
  a33=(a15*a32);
  a31=(a31-a33);
  a33=(a29+a31);
  a34=(a33*a21);
  a28=(a28*a05);
  a15=(a18*a15);
  a35=(a28+a15);
  a36=arg[1]? arg[1][2] : 0;
  a37=(a35*a36);
  a34=(a34+a37);
  a34=(a34*a19);
  a37=(a12*a34);
  a27=(a27+a37);
  a37=5.0000000000000000e-01;
  a27=(a27*a37);
  a27=(a27-a14);
  if (res[0]!=0) res[0][1]=a27;
  a27=(a23*a19);
  a38=(a14*a27);
  a39=(a18*a36);
  a40=(a32*a21);
  a39=(a39-a40);
  a39=(a39*a19);
  a40=(a12*a39);
  a38=(a38+a40);
  a38=(a38*a37);
  a11=(a18*a11);
  a11=(a11*a19);
  a38=(a38-a11);
  if (res[0]!=0) res[0][2]=a38;
  a38=(a20*a10);
  a40=(a38*a21);
  a41=(a36*a10);
  a40=(a40-a41);
  a40=(a40*a19);
  a41=(a12*a40);
  a41=(a41*a37);
  a41=(a12+a41);
  if (res[0]!=0) res[0][3]=a41;
  a41=(a20*a30);
  a42=(a28+a41);
  a42=(a42*a19);
  a43=(a12*a42);
  a22=(a00/a22);
  a44=(a19*a22);
  a14=(a14*a44);
  a43=(a43-a14);
  a43=(a43*a37);
  if (res[0]!=0) res[0][4]=a43;
  a11=(a11*a19);
  a43=(a29+a30);
  a43=(a43*a19);
  a14=(a12*a43);
  a11=(a11+a14);
  a11=(a11*a37);
  a11=(-a11);
  if (res[0]!=0) res[0][5]=a11;
  a11=arg[2]? arg[2][2] : 0;
  a11=(a11*a19);
  a14=(a12*a11);
  a14=(a14*a37);
  a14=(-a14);
  if (res[0]!=0) res[0][6]=a14;
  a14=arg[2]? arg[2][1] : 0;
  a14=(a14*a19);
  a12=(a12*a14);
  a12=(a12*a37);
  if (res[0]!=0) res[0][7]=a12;
  a12=(a00-a26);
  a45=(a26*a26);
  a46=(a05*a17);
  a46=(a46*a25);
  a46=(a46*a04);
  a46=(a46*a21);
  a46=(a46*a36);
  a24=(a24*a46);
  a33=(a33*a13);
  a24=(a24-a33);
  a24=(a24*a19);
  a33=(a44*a24);
  a45=(a45+a33);
  a46=(a45*a37);
  a12=(a12+a46);
  if (res[0]!=0) res[0][8]=a12;
  a12=(a26*a27);
  a46=(a13*a13);
  a46=(a46*a02);
  a20=(a20*a46);
  a23=(a23*a36);
  a20=(a20+a23);
  a20=(a20*a19);
  a23=(a44*a20);
  a12=(a12+a23);
  a12=(a12*a37);
  a12=(a12-a27);
  if (res[0]!=0) res[0][9]=a12;
  a23=2.;
  a02=(a23*a41);
  a28=(a28+a02);
  a28=(a28*a19);
  a02=(a44*a28);
  a02=(a02*a37);
  a25=(-a02);
  if (res[0]!=0) res[0][10]=a25;
  a25=(a26*a44);
  a36=(a36*a22);
  a36=(a36*a19);
  a47=(a44*a36);
  a25=(a25+a47);
  a25=(a25*a37);
  a25=(a44-a25);
  if (res[0]!=0) res[0][11]=a25;
  a47=(a27*a19);
  a48=(-a47);
  if (res[0]!=0) res[0][12]=a48;
  a48=(a11*a44);
  a49=(a48*a37);
  if (res[0]!=0) res[0][13]=a49;
  a49=arg[2]? arg[2][0] : 0;
  a49=(a49*a19);
  a50=(a44*a49);
  a51=(a50*a37);
  a51=(-a51);
  if (res[0]!=0) res[0][14]=a51;
  a35=(a35*a13);
  a13=(a21*a21);
  a13=(a13*a17);
  a08=(a08*a13);
  a35=(a35+a08);
  a08=4.2053793008804680e-09;
  a17=9.7803253359000006e+00;
  a51=1.8894147482439335e-02;
  a51=(a51*a06);
  a51=(a17+a51);
  a51=(a51*a09);
  a52=(a16*a51);
  a52=(a52*a01);
  a08=(a08*a52);
  a35=(a35+a08);
  a16=(a16*a09);
  a09=3.8637053131731361e-03;
  a08=1.2932555768154467e-05;
  a08=(a08*a06);
  a03=(a03+a08);
  a03=(a03/a07);
  a09=(a09+a03);
  a16=(a16*a09);
  a09=7.3745167729419953e-14;
  a03=(a01*a01);
  a09=(a09*a03);
  a09=(a00+a09);
  a03=1.5678559428873979e-07;
  a07=2.0136051943431768e+00;
  a08=1.3411242658989924e-02;
  a08=(a08*a06);
  a07=(a07-a08);
  a07=(a01*a07);
  a03=(a03*a07);
  a09=(a09-a03);
  a16=(a16*a09);
  a17=(a17*a16);
  a35=(a35+a17);
  a35=(a35*a19);
  a17=(a19*a35);
  a17=(a17*a37);
  a17=(-a17);
  if (res[0]!=0) res[0][15]=a17;
  a46=(a46+a13);
  a13=1.4749033545883991e-13;
  a13=(a13*a01);
  a01=2.1026896504402340e-09;
  a01=(a01*a06);
  a13=(a13+a01);
  a01=3.1570428705798834e-07;
  a13=(a13-a01);
  a51=(a51*a13);
  a46=(a46+a51);
  a46=(a46*a19);
  a51=(a19*a46);
  a13=(a51*a37);
  a13=(a00-a13);
  if (res[0]!=0) res[0][16]=a13;
  a13=(a23*a30);
  a29=(a29+a13);
  a29=(a29*a19);
  a13=(a19*a29);
  a13=(a13*a37);
  if (res[0]!=0) res[0][17]=a13;
  a21=(a21*a22);
  a23=(a23*a21);
  a23=(a23*a19);
  a22=(a19*a23);
  a22=(a22*a37);
  if (res[0]!=0) res[0][18]=a22;
  if (res[0]!=0) res[0][19]=a19;
  a22=(a19*a14);
  a22=(a22*a37);
  a22=(-a22);
  if (res[0]!=0) res[0][20]=a22;
  a22=(a19*a49);
  a22=(a22*a37);
  if (res[0]!=0) res[0][21]=a22;
  a22=(a40*a34);
  a13=(a34*a26);
  a22=(a22-a13);
  a13=(a42*a24);
  a22=(a22+a13);
  a13=(a43*a35);
  a22=(a22+a13);
  a13=7.2921149999999999e-05;
  a05=(a13*a05);
  a15=(a15+a05);
  a15=(a15*a19);
  a01=(a11*a15);
  a22=(a22+a01);
  a13=(a13*a04);
  a31=(a31+a13);
  a31=(a31*a19);
  a04=(a14*a31);
  a22=(a22+a04);
  a22=(a22*a37);
  a22=(a34+a22);
  if (res[0]!=0) res[0][22]=a22;
  a22=(a40*a39);
  a04=(a34*a27);
  a22=(a22-a04);
  a04=(a42*a20);
  a22=(a22+a04);
  a04=(a43*a46);
  a22=(a22+a04);
  a18=(a18*a19);
  a04=(a11*a18);
  a22=(a22+a04);
  a32=(a32*a19);
  a04=(a14*a32);
  a22=(a22-a04);
  a22=(a22*a37);
  a22=(a39+a22);
  if (res[0]!=0) res[0][23]=a22;
  a22=(a00+a40);
  a04=(a40*a40);
  a01=(a42*a28);
  a04=(a04-a01);
  a06=(a43*a29);
  a04=(a04-a06);
  a10=(a19*a10);
  a17=(a11*a10);
  a04=(a04-a17);
  a38=(a38*a19);
  a16=(a14*a38);
  a04=(a04+a16);
  a04=(a04*a37);
  a22=(a22+a04);
  if (res[0]!=0) res[0][24]=a22;
  a22=(a34*a44);
  a04=(a40*a42);
  a22=(a22+a04);
  a04=(a42*a36);
  a22=(a22-a04);
  a04=(a43*a23);
  a22=(a22-a04);
  a22=(a22*a37);
  a22=(a42+a22);
  if (res[0]!=0) res[0][25]=a22;
  a22=(a29*a40);
  a21=(a21*a19);
  a04=(a42*a21);
  a04=(a22+a04);
  a04=(a04*a37);
  a04=(a04+a43);
  a04=(-a04);
  if (res[0]!=0) res[0][26]=a04;
  a04=(a42*a11);
  a09=(a43*a14);
  a04=(a04+a09);
  a41=(a41+a05);
  a41=(a41*a19);
  a05=(a11*a41);
  a04=(a04+a05);
  a30=(a30+a13);
  a30=(a30*a19);
  a13=(a14*a30);
  a04=(a04+a13);
  a04=(a04*a37);
  if (res[0]!=0) res[0][27]=a04;
  a04=(a21*a14);
  a09=(a40*a11);
  a03=(a43*a49);
  a09=(a09+a03);
  a09=(a04-a09);
  a09=(a09*a37);
  a09=(a09-a11);
  if (res[0]!=0) res[0][28]=a09;
  a09=(a40*a14);
  a03=(a42*a49);
  a09=(a09-a03);
  a03=(a11*a21);
  a09=(a09+a03);
  a09=(a09*a37);
  a09=(a14+a09);
  if (res[0]!=0) res[0][29]=a09;
  a09=(a21*a35);
  a03=(a24*a26);
  a07=(a28*a34);
  a03=(a03+a07);
  a07=(a36*a24);
  a03=(a03+a07);
  a09=(a09-a03);
  a03=(a11*a26);
  a09=(a09+a03);
  a03=(a49*a31);
  a09=(a09-a03);
  a09=(a09*a37);
  a09=(a24+a09);
  if (res[0]!=0) res[0][30]=a09;
  a09=(a21*a46);
  a03=(a24*a27);
  a07=(a28*a39);
  a03=(a03+a07);
  a07=(a36*a20);
  a03=(a03+a07);
  a09=(a09-a03);
  a03=(a11*a27);
  a09=(a09+a03);
  a03=(a49*a32);
  a09=(a09+a03);
  a09=(a09*a37);
  a09=(a20+a09);
  if (res[0]!=0) res[0][31]=a09;
  a09=(a36*a28);
  a03=(a28*a40);
  a09=(a09-a03);
  a03=(a21*a29);
  a09=(a09-a03);
  a03=(a49*a38);
  a09=(a09-a03);
  a09=(a09*a37);
  a09=(a09-a28);
  if (res[0]!=0) res[0][32]=a09;
  a09=(a00-a36);
  a33=(a33-a01);
  a01=(a36*a36);
  a33=(a33+a01);
  a01=(a21*a23);
  a33=(a33-a01);
  a33=(a33-a48);
  a33=(a33*a37);
  a09=(a09+a33);
  if (res[0]!=0) res[0][33]=a09;
  a09=(a20*a19);
  a33=(a29*a42);
  a09=(a09+a33);
  a03=(a36*a21);
  a09=(a09+a03);
  a09=(a09*a37);
  a09=(a09-a21);
  if (res[0]!=0) res[0][34]=a09;
  a09=(a36*a11);
  a04=(a04-a09);
  a09=(a49*a30);
  a04=(a04-a09);
  a04=(a04*a37);
  a04=(a11+a04);
  if (res[0]!=0) res[0][35]=a04;
  a04=(a28*a11);
  a09=(a21*a49);
  a04=(a04-a09);
  a04=(a04+a05);
  a04=(a04-a09);
  a04=(a04*a37);
  if (res[0]!=0) res[0][36]=a04;
  a04=(a36*a49);
  a05=(a28*a14);
  a04=(a04-a05);
  a05=(a11*a30);
  a04=(a04-a05);
  a04=(a04*a37);
  a04=(a04-a49);
  if (res[0]!=0) res[0][37]=a04;
  a04=(a35*a26);
  a05=(a29*a34);
  a04=(a04+a05);
  a24=(a23*a24);
  a04=(a04+a24);
  a24=(a14*a26);
  a04=(a04-a24);
  a24=(a49*a15);
  a04=(a04-a24);
  a04=(a04*a37);
  a04=(a04-a35);
  if (res[0]!=0) res[0][38]=a04;
  a04=(a35*a27);
  a24=(a29*a39);
  a04=(a04+a24);
  a20=(a23*a20);
  a04=(a04+a20);
  a20=(a14*a27);
  a04=(a04-a20);
  a20=(a49*a18);
  a04=(a04-a20);
  a04=(a04*a37);
  a04=(a04-a46);
  if (res[0]!=0) res[0][39]=a04;
  a28=(a23*a28);
  a22=(a22-a28);
  a28=(a49*a10);
  a22=(a22+a28);
  a22=(a22*a37);
  a22=(a29+a22);
  if (res[0]!=0) res[0][40]=a22;
  a35=(a35*a44);
  a33=(a33-a35);
  a36=(a23*a36);
  a33=(a33-a36);
  a36=(a14*a44);
  a33=(a33+a36);
  a33=(a33*a37);
  a33=(a23+a33);
  if (res[0]!=0) res[0][41]=a33;
  a51=(a51+a06);
  a51=(a51+a01);
  a51=(a51*a37);
  a51=(a00-a51);
  if (res[0]!=0) res[0][42]=a51;
  a51=(a23*a11);
  a01=(a49*a41);
  a51=(a51-a01);
  a51=(a51*a37);
  a51=(a51-a14);
  if (res[0]!=0) res[0][43]=a51;
  a51=(a29*a11);
  a01=(a14*a41);
  a51=(a51+a01);
  a51=(a51*a37);
  a51=(a49-a51);
  if (res[0]!=0) res[0][44]=a51;
  a29=(a29*a14);
  a23=(a23*a49);
  a29=(a29-a23);
  a29=(a29+a13);
  a29=(a29-a09);
  a29=(a29*a37);
  if (res[0]!=0) res[0][45]=a29;
  a29=(a41*a15);
  a45=(a45+a29);
  a29=(a30*a31);
  a45=(a45+a29);
  a45=(a45*a37);
  a45=(a26-a45);
  if (res[0]!=0) res[0][46]=a45;
  a12=(-a12);
  if (res[0]!=0) res[0][47]=a12;
  if (res[0]!=0) res[0][48]=a02;
  a25=(-a25);
  if (res[0]!=0) res[0][49]=a25;
  if (res[0]!=0) res[0][50]=a47;
  a47=(a41*a41);
  a48=(a48+a47);
  a25=(a30*a30);
  a48=(a48+a25);
  a48=(a48*a37);
  a48=(a00-a48);
  if (res[0]!=0) res[0][51]=a48;
  a48=(a21*a30);
  a48=(a48*a37);
  a12=(a41-a48);
  if (res[0]!=0) res[0][52]=a12;
  a12=(a21*a41);
  a50=(a50-a12);
  a50=(a50*a37);
  a50=(a50-a30);
  if (res[0]!=0) res[0][53]=a50;
  a50=(a15*a26);
  a45=(a10*a34);
  a50=(a50+a45);
  a45=(a41*a26);
  a50=(a50-a45);
  a45=(a21*a31);
  a50=(a50-a45);
  a50=(a50*a37);
  a50=(a50-a15);
  if (res[0]!=0) res[0][54]=a50;
  a50=(a15*a27);
  a45=(a10*a39);
  a50=(a50+a45);
  a45=(a41*a27);
  a50=(a50-a45);
  a45=(a21*a32);
  a50=(a50+a45);
  a50=(a50*a37);
  a50=(a50-a18);
  if (res[0]!=0) res[0][55]=a50;
  a50=(a10*a40);
  a45=(a21*a38);
  a50=(a50-a45);
  a50=(a50*a37);
  a50=(a10+a50);
  if (res[0]!=0) res[0][56]=a50;
  a50=(a10*a42);
  a45=(a15*a44);
  a50=(a50-a45);
  a50=(a50+a02);
  a50=(a50*a37);
  if (res[0]!=0) res[0][57]=a50;
  a19=(a18*a19);
  a43=(a10*a43);
  a19=(a19+a43);
  a19=(a19*a37);
  a19=(-a19);
  if (res[0]!=0) res[0][58]=a19;
  a48=(a41+a48);
  a48=(-a48);
  if (res[0]!=0) res[0][59]=a48;
  a17=(a17+a47);
  a47=(a21*a21);
  a17=(a17+a47);
  a17=(a17*a37);
  a17=(a00-a17);
  if (res[0]!=0) res[0][60]=a17;
  a14=(a10*a14);
  a17=(a30*a41);
  a14=(a14+a17);
  a14=(a14*a37);
  a14=(a14-a21);
  if (res[0]!=0) res[0][61]=a14;
  a34=(a38*a34);
  a14=(a31*a26);
  a34=(a34-a14);
  a26=(a30*a26);
  a34=(a34+a26);
  a15=(a21*a15);
  a34=(a34-a15);
  a34=(a34*a37);
  a34=(a31+a34);
  if (res[0]!=0) res[0][62]=a34;
  a39=(a38*a39);
  a34=(a31*a27);
  a39=(a39-a34);
  a27=(a30*a27);
  a39=(a39+a27);
  a18=(a21*a18);
  a39=(a39-a18);
  a39=(a39*a37);
  a39=(a39-a32);
  if (res[0]!=0) res[0][63]=a39;
  a40=(a38*a40);
  a39=(a21*a10);
  a40=(a40+a39);
  a40=(a40*a37);
  a40=(a38+a40);
  if (res[0]!=0) res[0][64]=a40;
  a31=(a31*a44);
  a42=(a38*a42);
  a31=(a31+a42);
  a44=(a30*a44);
  a31=(a31-a44);
  a31=(a31*a37);
  if (res[0]!=0) res[0][65]=a31;
  a41=(a41*a10);
  a41=(-a41);
  if (res[0]!=0) res[0][66]=a41;
  a12=(a12*a37);
  a30=(a30-a12);
  if (res[0]!=0) res[0][67]=a30;
  a38=(a38*a11);
  a17=(a17-a38);
  a17=(a17*a37);
  a21=(a21+a17);
  if (res[0]!=0) res[0][68]=a21;
  a16=(a16-a25);
  a16=(a16-a47);
  a16=(a16*a37);
  a00=(a00+a16);
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


