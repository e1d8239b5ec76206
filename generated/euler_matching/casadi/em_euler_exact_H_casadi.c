/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) em_euler_exact_H_casadi__ ## ID
#endif

#include <math.h>
#include "../src/em_math.h"
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
CASADI_SYMBOL_EXPORT void em_euler_exact_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int em_euler_exact_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int em_euler_exact_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {6, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {18, 1, 1};

/* em_euler_exact_H_casadi:(x[6],mu[3],euler_b[3])->(out_H[18]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
  casadi_real a108, a109, a110;
  a000=2.;
  a001=arg[0]? arg[0][3] : 0;
  a002=arg[1]? arg[1][0] : 0;
  a001=(a001-a002);
  a002=5.0000000000000000e-01;
  a003=1.0000000000000001e-30;
  a004=(a001*a001);
  a004=(a003+a004);
  a005=arg[0]? arg[0][4] : 0;
  a006=arg[1]? arg[1][1] : 0;
  a005=(a005-a006);
  a006=(a005*a005);
  a004=(a004+a006);
  a006=arg[0]? arg[0][5] : 0;
  a007=arg[1]? arg[1][2] : 0;
  a006=(a006-a007);
  a007=(a006*a006);
  a004=(a004+a007);
  a004=sqrt(a004);
  a007=(a002*a004);
  a008=sin(a007);
  a009=1.;
  a004=(a009/a004);
  a010=(a008*a004);
  a011=(a001*a010);
  a012=(a000*a011);
  a013=(a005*a010);
  a014=(a012*a013);
  a007=cos(a007);
  a015=(a000*a007);
  a016=(a006*a010);
  a017=(a015*a016);
  a018=(a014-a017);
  a019=arg[0]? arg[0][2] : 0;
  a020=(a019*a019);
  a003=(a003+a020);
  a020=arg[0]? arg[0][1] : 0;
  a021=(a020*a020);
  a003=(a003+a021);
  a021=arg[0]? arg[0][0] : 0;
  a022=(a021*a021);
  a003=(a003+a022);
  a003=sqrt(a003);
  a022=(a002*a003);
  a023=sin(a022);
  a003=(a009/a003);
  a024=(a023*a003);
  a025=(a024*a021);
  a026=(a000*a025);
  a027=(a024*a019);
  a028=(a026*a027);
  a022=cos(a022);
  a029=(a000*a022);
  a030=(a024*a020);
  a031=(a029*a030);
  a032=(a028-a031);
  a033=arg[2]? arg[2][1] : 0;
  a034=cos(a033);
  a035=arg[2]? arg[2][2] : 0;
  a036=cos(a035);
  a037=(a034*a036);
  a038=(a032*a037);
  a039=(a029*a025);
  a040=(a000*a027);
  a041=(a040*a030);
  a042=(a039+a041);
  a035=sin(a035);
  a043=(a034*a035);
  a044=(a042*a043);
  a038=(a038+a044);
  a044=(a027*a027);
  a045=(a025*a025);
  a046=(a044-a045);
  a047=(a022*a022);
  a048=(a030*a030);
  a049=(a047-a048);
  a046=(a046+a049);
  a033=sin(a033);
  a050=(a046*a033);
  a038=(a038-a050);
  a050=(a018*a038);
  a051=(a013*a013);
  a052=(a016*a016);
  a053=(a051-a052);
  a054=(a007*a007);
  a055=(a011*a011);
  a056=(a054-a055);
  a053=(a053+a056);
  a057=arg[2]? arg[2][0] : 0;
  a058=sin(a057);
  a059=(a036*a058);
  a060=(a033*a059);
  a057=cos(a057);
  a061=(a035*a057);
  a060=(a060-a061);
  a062=(a032*a060);
  a036=(a036*a057);
  a035=(a035*a058);
  a063=(a033*a035);
  a063=(a036+a063);
  a064=(a042*a063);
  a062=(a062+a064);
  a058=(a034*a058);
  a064=(a046*a058);
  a062=(a062+a064);
  a064=(a053*a062);
  a050=(a050+a064);
  a064=(a015*a011);
  a065=(a000*a013);
  a066=(a065*a016);
  a067=(a064+a066);
  a036=(a033*a036);
  a035=(a035+a036);
  a032=(a032*a035);
  a061=(a033*a061);
  a061=(a061-a059);
  a042=(a042*a061);
  a032=(a032+a042);
  a034=(a034*a057);
  a046=(a046*a034);
  a032=(a032+a046);
  a046=(a067*a032);
  a050=(a050+a046);
  a046=(a050*a050);
  a057=(a015*a013);
  a042=(a012*a016);
  a059=(a057+a042);
  a036=(a059*a038);
  a066=(a066-a064);
  a064=(a066*a062);
  a036=(a036+a064);
  a056=(a052+a056);
  a056=(a056-a051);
  a064=(a056*a032);
  a036=(a036+a064);
  a064=(a036*a036);
  a046=(a046+a064);
  a064=(a009/a046);
  a050=(a050*a064);
  a068=(a021*a003);
  a069=(a002*a068);
  a070=(a022*a069);
  a070=(a070*a003);
  a071=(a024*a003);
  a068=(a071*a068);
  a070=(a070-a068);
  a021=(a021*a070);
  a021=(a021+a024);
  a068=(a000*a021);
  a072=(a027*a068);
  a073=(a019*a070);
  a074=(a026*a073);
  a072=(a072+a074);
  a070=(a020*a070);
  a075=(a029*a070);
  a076=(a030*a025);
  a075=(a075-a076);
  a076=(a072-a075);
  a077=(a037*a076);
  a078=(a029*a021);
  a078=(a078-a045);
  a079=(a000*a073);
  a079=(a030*a079);
  a079=(a000*a079);
  a080=(a078+a079);
  a081=(a043*a080);
  a077=(a077+a081);
  a081=(a040*a073);
  a021=(a026*a021);
  a082=(a081-a021);
  a069=(a023*a069);
  a069=(a029*a069);
  a083=(a000*a030);
  a084=(a083*a070);
  a085=(a069+a084);
  a082=(a082-a085);
  a086=(a033*a082);
  a077=(a077-a086);
  a086=(a059*a077);
  a087=(a060*a076);
  a088=(a063*a080);
  a087=(a087+a088);
  a088=(a058*a082);
  a087=(a087+a088);
  a088=(a066*a087);
  a086=(a086+a088);
  a076=(a035*a076);
  a080=(a061*a080);
  a076=(a076+a080);
  a082=(a034*a082);
  a076=(a076+a082);
  a082=(a056*a076);
  a086=(a086+a082);
  a086=(a050*a086);
  a036=(a036*a064);
  a082=(a018*a077);
  a080=(a053*a087);
  a082=(a082+a080);
  a080=(a067*a076);
  a082=(a082+a080);
  a082=(a036*a082);
  a086=(a086-a082);
  if (res[0]!=0) res[0][0]=a086;
  a086=(a020*a003);
  a082=(a002*a086);
  a080=(a022*a082);
  a080=(a080*a003);
  a086=(a071*a086);
  a080=(a080-a086);
  a020=(a020*a080);
  a020=(a020+a024);
  a086=(a029*a020);
  a086=(a086-a048);
  a088=(a079-a086);
  a089=(a037*a088);
  a080=(a019*a080);
  a090=(a000*a080);
  a090=(a030*a090);
  a091=(a040*a020);
  a091=(a090+a091);
  a092=(a075+a091);
  a093=(a043*a092);
  a089=(a089+a093);
  a093=(a040*a080);
  a070=(a026*a070);
  a094=(a093-a070);
  a082=(a023*a082);
  a082=(a029*a082);
  a083=(a083*a020);
  a095=(a082+a083);
  a094=(a094-a095);
  a096=(a033*a094);
  a089=(a089-a096);
  a096=(a059*a089);
  a097=(a060*a088);
  a098=(a063*a092);
  a097=(a097+a098);
  a098=(a058*a094);
  a097=(a097+a098);
  a098=(a066*a097);
  a096=(a096+a098);
  a088=(a035*a088);
  a092=(a061*a092);
  a088=(a088+a092);
  a094=(a034*a094);
  a088=(a088+a094);
  a094=(a056*a088);
  a096=(a096+a094);
  a096=(a050*a096);
  a094=(a018*a089);
  a092=(a053*a097);
  a094=(a094+a092);
  a092=(a067*a088);
  a094=(a094+a092);
  a094=(a036*a094);
  a096=(a096-a094);
  if (res[0]!=0) res[0][1]=a096;
  a096=(a019*a003);
  a094=(a002*a096);
  a022=(a022*a094);
  a022=(a022*a003);
  a071=(a071*a096);
  a022=(a022-a071);
  a019=(a019*a022);
  a019=(a019+a024);
  a024=(a026*a019);
  a024=(a081+a024);
  a080=(a029*a080);
  a022=(a027*a030);
  a080=(a080-a022);
  a022=(a024-a080);
  a071=(a037*a022);
  a073=(a029*a073);
  a025=(a027*a025);
  a073=(a073-a025);
  a025=(a000*a019);
  a025=(a030*a025);
  a025=(a025+a093);
  a096=(a073+a025);
  a003=(a043*a096);
  a071=(a071+a003);
  a040=(a040*a019);
  a003=(a040-a074);
  a023=(a023*a094);
  a023=(a029*a023);
  a094=(a023+a090);
  a003=(a003-a094);
  a092=(a033*a003);
  a071=(a071-a092);
  a059=(a059*a071);
  a092=(a060*a022);
  a098=(a063*a096);
  a092=(a092+a098);
  a098=(a058*a003);
  a092=(a092+a098);
  a066=(a066*a092);
  a059=(a059+a066);
  a022=(a035*a022);
  a096=(a061*a096);
  a022=(a022+a096);
  a003=(a034*a003);
  a022=(a022+a003);
  a056=(a056*a022);
  a059=(a059+a056);
  a059=(a050*a059);
  a018=(a018*a071);
  a053=(a053*a092);
  a018=(a018+a053);
  a067=(a067*a022);
  a018=(a018+a067);
  a018=(a036*a018);
  a059=(a059-a018);
  if (res[0]!=0) res[0][2]=a059;
  a059=(a001*a004);
  a018=(a002*a059);
  a067=(a007*a018);
  a067=(a067*a004);
  a053=(a010*a004);
  a059=(a053*a059);
  a067=(a067-a059);
  a059=(a005*a067);
  a056=(a015*a059);
  a003=(a013*a011);
  a056=(a056-a003);
  a001=(a001*a067);
  a001=(a010+a001);
  a003=(a000*a001);
  a096=(a016*a003);
  a067=(a006*a067);
  a066=(a012*a067);
  a096=(a096+a066);
  a098=(a056+a096);
  a098=(a038*a098);
  a099=(a000*a059);
  a099=(a016*a099);
  a099=(a000*a099);
  a100=(a015*a001);
  a100=(a100-a055);
  a101=(a099-a100);
  a101=(a062*a101);
  a098=(a098+a101);
  a101=(a000*a016);
  a102=(a101*a067);
  a018=(a008*a018);
  a018=(a015*a018);
  a001=(a012*a001);
  a103=(a018+a001);
  a104=(a102-a103);
  a105=(a065*a059);
  a104=(a104-a105);
  a104=(a032*a104);
  a098=(a098+a104);
  a098=(a050*a098);
  a003=(a013*a003);
  a059=(a012*a059);
  a003=(a003+a059);
  a067=(a015*a067);
  a011=(a016*a011);
  a067=(a067-a011);
  a011=(a003-a067);
  a011=(a038*a011);
  a104=(a105-a102);
  a104=(a104-a103);
  a104=(a062*a104);
  a011=(a011+a104);
  a100=(a100+a099);
  a100=(a032*a100);
  a011=(a011+a100);
  a011=(a036*a011);
  a098=(a098-a011);
  if (res[0]!=0) res[0][3]=a098;
  a098=(a005*a004);
  a011=(a002*a098);
  a100=(a007*a011);
  a100=(a100*a004);
  a098=(a053*a098);
  a100=(a100-a098);
  a005=(a005*a100);
  a005=(a010+a005);
  a098=(a015*a005);
  a098=(a098-a051);
  a104=(a098+a099);
  a104=(a038*a104);
  a103=(a000*a005);
  a103=(a016*a103);
  a100=(a006*a100);
  a106=(a065*a100);
  a103=(a103+a106);
  a107=(a103-a056);
  a107=(a062*a107);
  a104=(a104+a107);
  a107=(a101*a100);
  a011=(a008*a011);
  a011=(a015*a011);
  a108=(a011+a059);
  a109=(a107-a108);
  a110=(a065*a005);
  a109=(a109-a110);
  a109=(a032*a109);
  a104=(a104+a109);
  a104=(a050*a104);
  a005=(a012*a005);
  a005=(a105+a005);
  a100=(a015*a100);
  a016=(a016*a013);
  a100=(a100-a016);
  a016=(a005-a100);
  a016=(a038*a016);
  a013=(a110-a107);
  a013=(a013-a108);
  a013=(a062*a013);
  a016=(a016+a013);
  a103=(a056+a103);
  a103=(a032*a103);
  a016=(a016+a103);
  a016=(a036*a016);
  a104=(a104-a016);
  if (res[0]!=0) res[0][4]=a104;
  a104=(a006*a004);
  a002=(a002*a104);
  a007=(a007*a002);
  a007=(a007*a004);
  a053=(a053*a104);
  a007=(a007-a053);
  a006=(a006*a007);
  a010=(a010+a006);
  a012=(a012*a010);
  a012=(a102+a012);
  a006=(a100+a012);
  a006=(a038*a006);
  a065=(a065*a010);
  a065=(a107+a065);
  a007=(a065-a067);
  a007=(a062*a007);
  a006=(a006+a007);
  a101=(a101*a010);
  a008=(a008*a002);
  a008=(a015*a008);
  a002=(a008+a066);
  a007=(a101-a002);
  a007=(a007-a106);
  a007=(a032*a007);
  a006=(a006+a007);
  a050=(a050*a006);
  a015=(a015*a010);
  a015=(a015-a052);
  a010=(a099-a015);
  a010=(a038*a010);
  a006=(a106-a101);
  a006=(a006-a002);
  a006=(a062*a006);
  a010=(a010+a006);
  a065=(a067+a065);
  a065=(a032*a065);
  a010=(a010+a065);
  a036=(a036*a010);
  a050=(a050-a036);
  if (res[0]!=0) res[0][5]=a050;
  a050=sqrt(a046);
  a054=(a054-a052);
  a054=(a054+a055);
  a054=(a054-a051);
  a051=(a054*a038);
  a017=(a017+a014);
  a014=(a017*a062);
  a051=(a051+a014);
  a042=(a042-a057);
  a057=(a042*a032);
  a051=(a051+a057);
  a057=(a051*a051);
  a057=(a057+a046);
  a057=(a009/a057);
  a046=(a050*a057);
  a077=(a054*a077);
  a087=(a017*a087);
  a077=(a077+a087);
  a076=(a042*a076);
  a077=(a077+a076);
  a077=(a046*a077);
  a051=(a051*a057);
  a049=(a045+a049);
  a049=(a049-a044);
  a057=(a049*a037);
  a076=(a026*a030);
  a027=(a029*a027);
  a087=(a076-a027);
  a014=(a087*a043);
  a057=(a057+a014);
  a031=(a031+a028);
  a028=(a031*a033);
  a057=(a057-a028);
  a028=(a054*a057);
  a014=(a049*a060);
  a055=(a087*a063);
  a014=(a014+a055);
  a055=(a031*a058);
  a014=(a014+a055);
  a055=(a017*a014);
  a028=(a028+a055);
  a049=(a049*a035);
  a087=(a087*a061);
  a049=(a049+a087);
  a031=(a031*a034);
  a049=(a049+a031);
  a031=(a042*a049);
  a028=(a028+a031);
  a031=(a000*a028);
  a085=(a021-a085);
  a085=(a085-a081);
  a087=(a037*a085);
  a030=(a030*a068);
  a030=(a030+a070);
  a068=(a030-a073);
  a055=(a043*a068);
  a087=(a087+a055);
  a072=(a075+a072);
  a055=(a033*a072);
  a087=(a087-a055);
  a087=(a054*a087);
  a055=(a060*a085);
  a052=(a063*a068);
  a055=(a055+a052);
  a052=(a058*a072);
  a055=(a055+a052);
  a055=(a017*a055);
  a087=(a087+a055);
  a085=(a035*a085);
  a068=(a061*a068);
  a085=(a085+a068);
  a072=(a034*a072);
  a085=(a085+a072);
  a085=(a042*a085);
  a087=(a087+a085);
  a085=(a031*a087);
  a027=(a027+a076);
  a076=(a027*a037);
  a047=(a047-a045);
  a047=(a047+a048);
  a047=(a047-a044);
  a048=(a047*a043);
  a076=(a076+a048);
  a041=(a041-a039);
  a039=(a041*a033);
  a076=(a076-a039);
  a039=(a054*a076);
  a048=(a027*a060);
  a045=(a047*a063);
  a048=(a048+a045);
  a045=(a041*a058);
  a048=(a048+a045);
  a045=(a017*a048);
  a039=(a039+a045);
  a027=(a027*a035);
  a047=(a047*a061);
  a027=(a027+a047);
  a041=(a041*a034);
  a027=(a027+a041);
  a041=(a042*a027);
  a039=(a039+a041);
  a041=(a000*a039);
  a030=(a073+a030);
  a047=(a037*a030);
  a069=(a069+a021);
  a069=(a084-a069);
  a069=(a069-a081);
  a081=(a043*a069);
  a047=(a047+a081);
  a078=(a079-a078);
  a081=(a033*a078);
  a047=(a047-a081);
  a047=(a054*a047);
  a081=(a060*a030);
  a021=(a063*a069);
  a081=(a081+a021);
  a021=(a058*a078);
  a081=(a081+a021);
  a081=(a017*a081);
  a047=(a047+a081);
  a030=(a035*a030);
  a069=(a061*a069);
  a030=(a030+a069);
  a078=(a034*a078);
  a030=(a030+a078);
  a030=(a042*a030);
  a047=(a047+a030);
  a030=(a041*a047);
  a085=(a085+a030);
  a000=(a000*a050);
  a009=(a009/a000);
  a085=(a085*a009);
  a085=(a051*a085);
  a077=(a077-a085);
  if (res[0]!=0) res[0][6]=a077;
  a089=(a054*a089);
  a097=(a017*a097);
  a089=(a089+a097);
  a088=(a042*a088);
  a089=(a089+a088);
  a089=(a046*a089);
  a095=(a070-a095);
  a095=(a095-a093);
  a088=(a037*a095);
  a026=(a026*a020);
  a084=(a084+a026);
  a026=(a084-a080);
  a020=(a043*a026);
  a088=(a088+a020);
  a086=(a086+a079);
  a020=(a033*a086);
  a088=(a088-a020);
  a088=(a054*a088);
  a020=(a060*a095);
  a097=(a063*a026);
  a020=(a020+a097);
  a097=(a058*a086);
  a020=(a020+a097);
  a020=(a017*a020);
  a088=(a088+a020);
  a095=(a035*a095);
  a026=(a061*a026);
  a095=(a095+a026);
  a086=(a034*a086);
  a095=(a095+a086);
  a095=(a042*a095);
  a088=(a088+a095);
  a095=(a031*a088);
  a084=(a080+a084);
  a086=(a037*a084);
  a082=(a082+a070);
  a083=(a083-a082);
  a083=(a083-a093);
  a093=(a043*a083);
  a086=(a086+a093);
  a091=(a091-a075);
  a075=(a033*a091);
  a086=(a086-a075);
  a086=(a054*a086);
  a075=(a060*a084);
  a093=(a063*a083);
  a075=(a075+a093);
  a093=(a058*a091);
  a075=(a075+a093);
  a075=(a017*a075);
  a086=(a086+a075);
  a084=(a035*a084);
  a083=(a061*a083);
  a084=(a084+a083);
  a091=(a034*a091);
  a084=(a084+a091);
  a084=(a042*a084);
  a086=(a086+a084);
  a084=(a041*a086);
  a095=(a095+a084);
  a095=(a095*a009);
  a095=(a051*a095);
  a089=(a089-a095);
  if (res[0]!=0) res[0][7]=a089;
  a071=(a054*a071);
  a092=(a017*a092);
  a071=(a071+a092);
  a022=(a042*a022);
  a071=(a071+a022);
  a071=(a046*a071);
  a094=(a074-a094);
  a094=(a094-a040);
  a022=(a037*a094);
  a029=(a029*a019);
  a029=(a029-a044);
  a044=(a079-a029);
  a019=(a043*a044);
  a022=(a022+a019);
  a080=(a080+a024);
  a024=(a033*a080);
  a022=(a022-a024);
  a022=(a054*a022);
  a024=(a060*a094);
  a019=(a063*a044);
  a024=(a024+a019);
  a019=(a058*a080);
  a024=(a024+a019);
  a024=(a017*a024);
  a022=(a022+a024);
  a094=(a035*a094);
  a044=(a061*a044);
  a094=(a094+a044);
  a080=(a034*a080);
  a094=(a094+a080);
  a094=(a042*a094);
  a022=(a022+a094);
  a094=(a031*a022);
  a029=(a029+a079);
  a037=(a037*a029);
  a023=(a023+a074);
  a090=(a090-a023);
  a090=(a090-a040);
  a043=(a043*a090);
  a037=(a037+a043);
  a025=(a025-a073);
  a033=(a033*a025);
  a037=(a037-a033);
  a054=(a054*a037);
  a060=(a060*a029);
  a063=(a063*a090);
  a060=(a060+a063);
  a058=(a058*a025);
  a060=(a060+a058);
  a017=(a017*a060);
  a054=(a054+a017);
  a035=(a035*a029);
  a061=(a061*a090);
  a035=(a035+a061);
  a034=(a034*a025);
  a035=(a035+a034);
  a042=(a042*a035);
  a054=(a054+a042);
  a042=(a041*a054);
  a094=(a094+a042);
  a094=(a094*a009);
  a094=(a051*a094);
  a071=(a071-a094);
  if (res[0]!=0) res[0][8]=a071;
  a018=(a018+a102);
  a001=(a001-a018);
  a001=(a001-a105);
  a105=(a038*a001);
  a067=(a067+a003);
  a003=(a062*a067);
  a105=(a105+a003);
  a096=(a096-a056);
  a056=(a032*a096);
  a105=(a105+a056);
  a105=(a046*a105);
  a056=(a057*a001);
  a003=(a014*a067);
  a056=(a056+a003);
  a003=(a049*a096);
  a056=(a056+a003);
  a003=(a031*a056);
  a001=(a076*a001);
  a067=(a048*a067);
  a001=(a001+a067);
  a096=(a027*a096);
  a001=(a001+a096);
  a096=(a041*a001);
  a003=(a003+a096);
  a003=(a003*a009);
  a003=(a051*a003);
  a105=(a105-a003);
  if (res[0]!=0) res[0][9]=a105;
  a011=(a011+a107);
  a059=(a059-a011);
  a059=(a059-a110);
  a110=(a038*a059);
  a005=(a100+a005);
  a011=(a062*a005);
  a110=(a110+a011);
  a098=(a099-a098);
  a011=(a032*a098);
  a110=(a110+a011);
  a110=(a046*a110);
  a011=(a057*a059);
  a107=(a014*a005);
  a011=(a011+a107);
  a107=(a049*a098);
  a011=(a011+a107);
  a107=(a031*a011);
  a059=(a076*a059);
  a005=(a048*a005);
  a059=(a059+a005);
  a098=(a027*a098);
  a059=(a059+a098);
  a098=(a041*a059);
  a107=(a107+a098);
  a107=(a107*a009);
  a107=(a051*a107);
  a110=(a110-a107);
  if (res[0]!=0) res[0][10]=a110;
  a008=(a008+a101);
  a066=(a066-a008);
  a066=(a066-a106);
  a038=(a038*a066);
  a015=(a015+a099);
  a062=(a062*a015);
  a038=(a038+a062);
  a012=(a012-a100);
  a032=(a032*a012);
  a038=(a038+a032);
  a046=(a046*a038);
  a057=(a057*a066);
  a014=(a014*a015);
  a057=(a057+a014);
  a049=(a049*a012);
  a057=(a057+a049);
  a031=(a031*a057);
  a076=(a076*a066);
  a048=(a048*a015);
  a076=(a076+a048);
  a027=(a027*a012);
  a076=(a076+a027);
  a041=(a041*a076);
  a031=(a031+a041);
  a031=(a031*a009);
  a051=(a051*a031);
  a046=(a046-a051);
  if (res[0]!=0) res[0][11]=a046;
  a039=(a039*a064);
  a087=(a039*a087);
  a028=(a028*a064);
  a047=(a028*a047);
  a087=(a087-a047);
  if (res[0]!=0) res[0][12]=a087;
  a088=(a039*a088);
  a086=(a028*a086);
  a088=(a088-a086);
  if (res[0]!=0) res[0][13]=a088;
  a022=(a039*a022);
  a054=(a028*a054);
  a022=(a022-a054);
  if (res[0]!=0) res[0][14]=a022;
  a056=(a039*a056);
  a001=(a028*a001);
  a056=(a056-a001);
  if (res[0]!=0) res[0][15]=a056;
  a011=(a039*a011);
  a059=(a028*a059);
  a011=(a011-a059);
  if (res[0]!=0) res[0][16]=a011;
  a039=(a039*a057);
  a028=(a028*a076);
  a039=(a039-a028);
  if (res[0]!=0) res[0][17]=a039;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_euler_exact_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int em_euler_exact_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void em_euler_exact_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void em_euler_exact_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void em_euler_exact_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int em_euler_exact_H_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int em_euler_exact_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real em_euler_exact_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_euler_exact_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "mu";
    case 2: return "euler_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_euler_exact_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_euler_exact_H_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_euler_exact_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int em_euler_exact_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_euler_exact_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


