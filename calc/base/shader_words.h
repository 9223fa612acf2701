// Macros for formulas that are compiled as C++ and as GLSL: their .glsl files are beside the
// headers that include them, between this and shader_words_end.h. In GLSL, DBL(0.5) becomes 0.5lf
// (gpu/gather/shader_text).
// No include guard, because every such text defines and undefines these macros.
#define TERM inline
#define UINT std::uint32_t
#define DVEC3 glm::dvec3
#define IN_DVEC3 const glm::dvec3&
#define DBL(x) x
#define SIGN_OF(x) std::copysign(1.0, x)
