/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_dcm_exact_h_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vd_dcm_exact_h_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {10, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {3, 1, 1};

/* vd_dcm_exact_h_casadi:(x[10],q_b2n_wxyz[4],mu[3],q_r2n_wxyz[4],omega_nr_n[3])->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92;
  a00=arg[2]? arg[2][0] : 0;
  a01=arg[0]? arg[0][6] : 0;
  a01=(a00-a01);
  a02=5.0000000000000000e-01;
  a03=1.0000000000000001e-30;
  a04=(a01*a01);
  a05=(a03+a04);
  a06=arg[2]? arg[2][1] : 0;
  a07=arg[0]? arg[0][7] : 0;
  a07=(a06-a07);
  a08=(a07*a07);
  a05=(a05+a08);
  a09=arg[2]? arg[2][2] : 0;
  a10=arg[0]? arg[0][8] : 0;
  a10=(a09-a10);
  a11=(a10*a10);
  a05=(a05+a11);
  a12=sqrt(a05);
  a13=(a02*a12);
  a14=sin(a13);
  a15=(a14*a14);
  a16=1.;
  a16=(a16/a05);
  a05=(a15*a16);
  a17=(a01*a05);
  a18=2.;
  a19=(a18*a10);
  a20=(a17*a19);
  a21=(a18*a07);
  a13=cos(a13);
  a14=(a14*a13);
  a14=(a14/a12);
  a12=(a21*a14);
  a22=(a20-a12);
  a23=arg[3]? arg[3][2] : 0;
  a24=arg[3]? arg[3][3] : 0;
  a25=(a23*a24);
  a25=(a18*a25);
  a26=arg[3]? arg[3][0] : 0;
  a27=(a18*a26);
  a28=arg[3]? arg[3][1] : 0;
  a29=(a27*a28);
  a25=(a25-a29);
  a30=(a22*a25);
  a17=(a17*a21);
  a19=(a19*a14);
  a31=(a17+a19);
  a32=(a23*a23);
  a26=(a26*a26);
  a33=(a28*a28);
  a34=(a26-a33);
  a35=(a32+a34);
  a36=(a24*a24);
  a35=(a35-a36);
  a37=(a31*a35);
  a30=(a30+a37);
  a13=(a13*a13);
  a11=(a11*a05);
  a37=(a13-a11);
  a04=(a04*a05);
  a08=(a08*a05);
  a38=(a04-a08);
  a37=(a37+a38);
  a39=(a27*a24);
  a40=(a28*a23);
  a40=(a18*a40);
  a41=(a39+a40);
  a42=(a37*a41);
  a30=(a30+a42);
  a42=arg[0]? arg[0][3] : 0;
  a43=(a18*a42);
  a42=(a42*a42);
  a44=(a03+a42);
  a45=arg[0]? arg[0][4] : 0;
  a46=(a45*a45);
  a44=(a44+a46);
  a47=arg[0]? arg[0][5] : 0;
  a48=(a47*a47);
  a44=(a44+a48);
  a49=sqrt(a44);
  a50=(a02*a49);
  a51=sin(a50);
  a52=(a51*a51);
  a52=(a52/a44);
  a44=(a52*a47);
  a53=(a43*a44);
  a50=cos(a50);
  a51=(a51*a50);
  a51=(a51/a49);
  a49=(a18*a45);
  a54=(a51*a49);
  a55=(a53+a54);
  a56=arg[4]? arg[4][0] : 0;
  a57=(a18*a56);
  a58=arg[0]? arg[0][9] : 0;
  a59=(a58*a58);
  a56=(a56*a56);
  a56=(a59*a56);
  a60=(a03+a56);
  a61=arg[4]? arg[4][1] : 0;
  a62=(a61*a61);
  a62=(a59*a62);
  a60=(a60+a62);
  a63=arg[4]? arg[4][2] : 0;
  a64=(a63*a63);
  a64=(a59*a64);
  a60=(a60+a64);
  a65=sqrt(a60);
  a66=(a02*a65);
  a67=sin(a66);
  a68=(a67*a67);
  a68=(a68/a60);
  a60=(a59*a68);
  a60=(a60*a63);
  a69=(a57*a60);
  a66=cos(a66);
  a67=(a67*a66);
  a67=(a67*a58);
  a67=(a67/a65);
  a65=(a18*a61);
  a58=(a67*a65);
  a70=(a69-a58);
  a71=(a55*a70);
  a72=(a52*a45);
  a72=(a72*a47);
  a72=(a18*a72);
  a73=(a43*a51);
  a72=(a72-a73);
  a60=(a60*a65);
  a65=(a57*a67);
  a74=(a60+a65);
  a75=(a72*a74);
  a71=(a71+a75);
  a46=(a46*a52);
  a48=(a48*a52);
  a75=(a46-a48);
  a42=(a42*a52);
  a50=(a50*a50);
  a76=(a42-a50);
  a75=(a75+a76);
  a62=(a62*a68);
  a64=(a64*a68);
  a77=(a62-a64);
  a56=(a56*a68);
  a66=(a66*a66);
  a78=(a56-a66);
  a77=(a77+a78);
  a79=(a75*a77);
  a71=(a71+a79);
  a79=arg[1]? arg[1][1] : 0;
  a80=arg[1]? arg[1][3] : 0;
  a81=(a79*a80);
  a81=(a18*a81);
  a82=arg[1]? arg[1][0] : 0;
  a83=(a18*a82);
  a84=arg[1]? arg[1][2] : 0;
  a85=(a83*a84);
  a86=(a81-a85);
  a87=(a71*a86);
  a87=(a02*a87);
  a43=(a43*a52);
  a43=(a43*a45);
  a51=(a51*a47);
  a51=(a18*a51);
  a47=(a43-a51);
  a45=(a70*a47);
  a76=(a48+a76);
  a76=(a76-a46);
  a52=(a74*a76);
  a45=(a45-a52);
  a44=(a44*a49);
  a73=(a73+a44);
  a44=(a77*a73);
  a45=(a45-a44);
  a44=(a83*a80);
  a49=(a18*a84);
  a52=(a49*a79);
  a52=(a44+a52);
  a88=(a45*a52);
  a88=(a02*a88);
  a87=(a87+a88);
  a88=(a79*a79);
  a89=(a84*a84);
  a90=(a88-a89);
  a82=(a82*a82);
  a91=(a80*a80);
  a92=(a82-a91);
  a90=(a90+a92);
  a50=(a50-a48);
  a50=(a50+a42);
  a50=(a50-a46);
  a70=(a70*a50);
  a43=(a43+a51);
  a74=(a74*a43);
  a70=(a70+a74);
  a53=(a53-a54);
  a77=(a77*a53);
  a70=(a70-a77);
  a77=(a90*a70);
  a77=(a02*a77);
  a87=(a87+a77);
  a77=(a30*a87);
  a01=(a01*a14);
  a01=(a18*a01);
  a05=(a10*a05);
  a05=(a05*a21);
  a05=(a01+a05);
  a21=(a05*a25);
  a17=(a17-a19);
  a19=(a17*a41);
  a21=(a21+a19);
  a38=(a11+a38);
  a38=(a38-a13);
  a19=(a38*a35);
  a21=(a21-a19);
  a83=(a83*a79);
  a49=(a49*a80);
  a49=(a83+a49);
  a19=(a71*a49);
  a19=(a02*a19);
  a14=(a89-a88);
  a14=(a14+a92);
  a92=(a45*a14);
  a92=(a02*a92);
  a19=(a19+a92);
  a79=(a79*a84);
  a79=(a18*a79);
  a79=(a79-a44);
  a44=(a70*a79);
  a44=(a02*a44);
  a19=(a19+a44);
  a44=(a21*a19);
  a77=(a77+a44);
  a12=(a12+a20);
  a20=(a12*a41);
  a07=(a07*a10);
  a07=(a07*a16);
  a07=(a07*a15);
  a07=(a18*a07);
  a07=(a07-a01);
  a01=(a07*a35);
  a20=(a20+a01);
  a04=(a04-a11);
  a04=(a04+a08);
  a04=(a04-a13);
  a13=(a04*a25);
  a20=(a20-a13);
  a82=(a82+a91);
  a82=(a82-a88);
  a82=(a82-a89);
  a71=(a71*a82);
  a71=(a02*a71);
  a84=(a84*a80);
  a84=(a18*a84);
  a84=(a84-a83);
  a45=(a45*a84);
  a45=(a02*a45);
  a71=(a71+a45);
  a85=(a85+a81);
  a70=(a70*a85);
  a70=(a02*a70);
  a71=(a71+a70);
  a70=(a20*a71);
  a77=(a77+a70);
  a70=(a00*a00);
  a03=(a03+a70);
  a81=(a06*a06);
  a03=(a03+a81);
  a45=(a09*a09);
  a03=(a03+a45);
  a83=sqrt(a03);
  a80=(a02*a83);
  a89=sin(a80);
  a88=(a89*a89);
  a88=(a88/a03);
  a03=(a88*a06);
  a03=(a03*a09);
  a03=(a18*a03);
  a00=(a18*a00);
  a80=cos(a80);
  a89=(a89*a80);
  a89=(a89/a83);
  a83=(a00*a89);
  a03=(a03-a83);
  a91=(a18*a24);
  a13=(a91*a23);
  a29=(a29+a13);
  a13=(a03*a29);
  a13=(a02*a13);
  a24=(a28*a24);
  a24=(a18*a24);
  a27=(a27*a23);
  a24=(a24-a27);
  a23=(a88*a09);
  a08=(a00*a23);
  a11=(a18*a06);
  a01=(a89*a11);
  a15=(a08+a01);
  a16=(a24*a15);
  a16=(a02*a16);
  a13=(a13+a16);
  a16=(a36-a32);
  a16=(a16+a34);
  a81=(a88*a81);
  a80=(a80*a80);
  a34=(a81-a80);
  a70=(a88*a70);
  a45=(a88*a45);
  a10=(a70-a45);
  a34=(a34+a10);
  a44=(a16*a34);
  a44=(a02*a44);
  a13=(a13-a44);
  a44=(a84*a13);
  a77=(a77+a44);
  a10=(a80+a10);
  a10=(a10-a81);
  a44=(a24*a10);
  a44=(a02*a44);
  a08=(a08-a01);
  a01=(a16*a08);
  a01=(a02*a01);
  a44=(a44+a01);
  a00=(a00*a88);
  a00=(a00*a06);
  a89=(a89*a09);
  a89=(a18*a89);
  a09=(a00+a89);
  a06=(a29*a09);
  a06=(a02*a06);
  a44=(a44+a06);
  a06=(a52*a44);
  a77=(a77+a06);
  a00=(a00-a89);
  a89=(a24*a00);
  a89=(a02*a89);
  a23=(a23*a11);
  a83=(a83+a23);
  a23=(a16*a83);
  a23=(a02*a23);
  a89=(a89+a23);
  a70=(a70-a80);
  a70=(a70+a45);
  a70=(a70-a81);
  a81=(a70*a29);
  a81=(a02*a81);
  a89=(a89-a81);
  a81=(a14*a89);
  a77=(a77+a81);
  a57=(a57*a59);
  a57=(a57*a68);
  a57=(a57*a61);
  a67=(a67*a63);
  a18=(a18*a67);
  a67=(a57+a18);
  a63=(a50*a67);
  a78=(a64+a78);
  a78=(a78-a62);
  a61=(a43*a78);
  a63=(a63-a61);
  a60=(a60-a65);
  a65=(a53*a60);
  a63=(a63+a65);
  a65=(a90*a63);
  a61=(a55*a67);
  a68=(a72*a78);
  a61=(a61-a68);
  a68=(a75*a60);
  a61=(a61-a68);
  a68=(a61*a86);
  a65=(a65+a68);
  a67=(a47*a67);
  a78=(a76*a78);
  a67=(a67+a78);
  a60=(a73*a60);
  a67=(a67+a60);
  a60=(a67*a52);
  a65=(a65+a60);
  a60=(a22*a16);
  a60=(a02*a60);
  a78=(a31*a29);
  a78=(a02*a78);
  a60=(a60+a78);
  a78=(a37*a24);
  a78=(a02*a78);
  a60=(a60+a78);
  a78=(a65*a60);
  a77=(a77-a78);
  a78=(a85*a63);
  a68=(a84*a67);
  a78=(a78+a68);
  a68=(a61*a82);
  a78=(a78+a68);
  a68=(a12*a24);
  a68=(a02*a68);
  a59=(a07*a29);
  a59=(a02*a59);
  a68=(a68+a59);
  a59=(a04*a16);
  a59=(a02*a59);
  a68=(a68-a59);
  a59=(a78*a68);
  a77=(a77-a59);
  a63=(a79*a63);
  a61=(a61*a49);
  a63=(a63+a61);
  a67=(a67*a14);
  a63=(a63+a67);
  a16=(a05*a16);
  a16=(a02*a16);
  a24=(a17*a24);
  a24=(a02*a24);
  a16=(a16+a24);
  a29=(a38*a29);
  a29=(a02*a29);
  a16=(a16-a29);
  a29=(a63*a16);
  a77=(a77-a29);
  a29=(a25*a83);
  a24=(a41*a00);
  a29=(a29+a24);
  a24=(a35*a70);
  a29=(a29-a24);
  a24=(a02*a49);
  a67=(a29*a24);
  a77=(a77-a67);
  a67=(a25*a08);
  a61=(a41*a10);
  a67=(a67+a61);
  a61=(a35*a09);
  a67=(a67+a61);
  a61=(a02*a86);
  a59=(a67*a61);
  a77=(a77-a59);
  a35=(a03*a35);
  a41=(a15*a41);
  a35=(a35+a41);
  a25=(a34*a25);
  a35=(a35-a25);
  a25=(a02*a82);
  a41=(a35*a25);
  a77=(a77-a41);
  if (res[0]!=0) res[0][0]=a77;
  a57=(a57-a18);
  a43=(a43*a57);
  a66=(a66-a64);
  a66=(a66+a56);
  a66=(a66-a62);
  a50=(a50*a66);
  a43=(a43+a50);
  a69=(a69+a58);
  a53=(a53*a69);
  a43=(a43+a53);
  a53=(a90*a43);
  a55=(a55*a66);
  a72=(a72*a57);
  a55=(a55+a72);
  a75=(a75*a69);
  a55=(a55-a75);
  a86=(a55*a86);
  a53=(a53+a86);
  a47=(a47*a66);
  a76=(a76*a57);
  a47=(a47-a76);
  a73=(a73*a69);
  a47=(a47+a73);
  a73=(a47*a52);
  a53=(a53+a73);
  a60=(a60*a53);
  a73=(a85*a43);
  a69=(a84*a47);
  a73=(a73+a69);
  a82=(a55*a82);
  a73=(a73+a82);
  a68=(a68*a73);
  a60=(a60+a68);
  a43=(a79*a43);
  a55=(a55*a49);
  a43=(a43+a55);
  a47=(a47*a14);
  a43=(a43+a47);
  a16=(a16*a43);
  a60=(a60+a16);
  a91=(a91*a28);
  a27=(a27+a91);
  a83=(a27*a83);
  a26=(a26-a32);
  a26=(a26+a33);
  a26=(a26-a36);
  a00=(a26*a00);
  a83=(a83+a00);
  a40=(a40-a39);
  a70=(a40*a70);
  a83=(a83-a70);
  a24=(a83*a24);
  a60=(a60+a24);
  a08=(a27*a08);
  a10=(a26*a10);
  a08=(a08+a10);
  a09=(a40*a09);
  a08=(a08+a09);
  a61=(a08*a61);
  a60=(a60+a61);
  a03=(a03*a40);
  a34=(a27*a34);
  a03=(a03-a34);
  a15=(a26*a15);
  a03=(a03+a15);
  a25=(a03*a25);
  a60=(a60+a25);
  a44=(a90*a44);
  a60=(a60-a44);
  a22=(a22*a27);
  a31=(a31*a40);
  a22=(a22+a31);
  a37=(a37*a26);
  a22=(a22+a37);
  a87=(a87*a22);
  a60=(a60-a87);
  a89=(a79*a89);
  a60=(a60-a89);
  a05=(a05*a27);
  a17=(a17*a26);
  a05=(a05+a17);
  a38=(a38*a40);
  a05=(a05-a38);
  a19=(a19*a05);
  a60=(a60-a19);
  a13=(a85*a13);
  a60=(a60-a13);
  a12=(a12*a26);
  a07=(a07*a40);
  a12=(a12+a07);
  a04=(a04*a27);
  a12=(a12-a04);
  a71=(a71*a12);
  a60=(a60-a71);
  if (res[0]!=0) res[0][1]=a60;
  a90=(a90*a67);
  a90=(a02*a90);
  a79=(a79*a29);
  a79=(a02*a79);
  a90=(a90+a79);
  a85=(a85*a35);
  a85=(a02*a85);
  a90=(a90+a85);
  a65=(a65*a22);
  a65=(a02*a65);
  a90=(a90+a65);
  a78=(a78*a12);
  a78=(a02*a78);
  a90=(a90+a78);
  a63=(a63*a05);
  a63=(a02*a63);
  a90=(a90+a63);
  a30=(a30*a53);
  a30=(a02*a30);
  a90=(a90-a30);
  a21=(a21*a43);
  a21=(a02*a21);
  a90=(a90-a21);
  a20=(a20*a73);
  a20=(a02*a20);
  a90=(a90-a20);
  a84=(a84*a03);
  a84=(a02*a84);
  a90=(a90-a84);
  a83=(a83*a14);
  a83=(a02*a83);
  a90=(a90-a83);
  a08=(a08*a52);
  a02=(a02*a08);
  a90=(a90-a02);
  if (res[0]!=0) res[0][2]=a90;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_h_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_h_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_h_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_exact_h_casadi_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_exact_h_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vd_dcm_exact_h_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_exact_h_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "q_b2n_wxyz";
    case 2: return "mu";
    case 3: return "q_r2n_wxyz";
    case 4: return "omega_nr_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_exact_h_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_exact_h_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s1;
    case 4: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_exact_h_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_h_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


