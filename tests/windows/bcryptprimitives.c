// Wine before version 9 lacks this library, and Rust's programs take their random seeds from it: the same bytes from another function.
#include <windows.h>
#include <ntsecapi.h>

__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE bytes, SIZE_T length) { return RtlGenRandom(bytes, (ULONG)length); }
