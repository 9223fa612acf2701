#undef TERM
#undef UINT
#undef DVEC3
#undef IN_DVEC3
#undef DBL
#undef SIGN_OF
