// See taken_names.h. The tables are what g++ and clang++ on Linux and nvcc define after the headers of C, C++, POSIX,
// Eigen, xsimd and CUDA, without what the rules below tell by its form.
#include "emit/cpp/taken_names.h"

#include <algorithm>
#include <cctype>
#include <span>

namespace physgen::emit::cpp {
namespace {

// Numbers of errors, <cerrno>.
constexpr std::string_view error_numbers[] = {
    "E2BIG",           "EACCES",       "EADDRINUSE",   "EADDRNOTAVAIL",   "EADV",
    "EAFNOSUPPORT",    "EAGAIN",       "EALREADY",     "EBADE",           "EBADF",
    "EBADFD",          "EBADMSG",      "EBADR",        "EBADRQC",         "EBADSLT",
    "EBFONT",          "EBUSY",        "ECANCELED",    "ECHILD",          "ECHRNG",
    "ECOMM",           "ECONNABORTED", "ECONNREFUSED", "ECONNRESET",      "EDEADLK",
    "EDEADLOCK",       "EDESTADDRREQ", "EDOM",         "EDOTDOT",         "EDQUOT",
    "EEXIST",          "EFAULT",       "EFBIG",        "EHOSTDOWN",       "EHOSTUNREACH",
    "EHWPOISON",       "EIDRM",        "EILSEQ",       "EINPROGRESS",     "EINTR",
    "EINVAL",          "EIO",          "EISCONN",      "EISDIR",          "EISNAM",
    "EKEYEXPIRED",     "EKEYREJECTED", "EKEYREVOKED",  "EL2HLT",          "EL2NSYNC",
    "EL3HLT",          "EL3RST",       "ELIBACC",      "ELIBBAD",         "ELIBEXEC",
    "ELIBMAX",         "ELIBSCN",      "ELNRNG",       "ELOOP",           "EMEDIUMTYPE",
    "EMFILE",          "EMLINK",       "EMSGSIZE",     "EMULTIHOP",       "ENAMETOOLONG",
    "ENAVAIL",         "ENETDOWN",     "ENETRESET",    "ENETUNREACH",     "ENFILE",
    "ENOANO",          "ENOBUFS",      "ENOCSI",       "ENODATA",         "ENODEV",
    "ENOENT",          "ENOEXEC",      "ENOKEY",       "ENOLCK",          "ENOLINK",
    "ENOMEDIUM",       "ENOMEM",       "ENOMSG",       "ENONET",          "ENOPKG",
    "ENOPROTOOPT",     "ENOSPC",       "ENOSR",        "ENOSTR",          "ENOSYS",
    "ENOTBLK",         "ENOTCONN",     "ENOTDIR",      "ENOTEMPTY",       "ENOTNAM",
    "ENOTRECOVERABLE", "ENOTSOCK",     "ENOTSUP",      "ENOTTY",          "ENOTUNIQ",
    "ENXIO",           "EOPNOTSUPP",   "EOVERFLOW",    "EOWNERDEAD",      "EPERM",
    "EPFNOSUPPORT",    "EPIPE",        "EPROTO",       "EPROTONOSUPPORT", "EPROTOTYPE",
    "ERANGE",          "EREMCHG",      "EREMOTE",      "EREMOTEIO",       "ERESTART",
    "ERFKILL",         "EROFS",        "ESHUTDOWN",    "ESOCKTNOSUPPORT", "ESPIPE",
    "ESRCH",           "ESRMNT",       "ESTALE",       "ESTRPIPE",        "ETIME",
    "ETIMEDOUT",       "ETOOMANYREFS", "ETXTBSY",      "EUCLEAN",         "EUNATCH",
    "EUSERS",          "EWOULDBLOCK",  "EXDEV",        "EXFULL"};

// From <csignal>, <sys/wait.h> and <cmath>.
constexpr std::string_view signals_and_states[] = {
    "SIGABRT",     "SIGALRM",      "SIGBUS",    "SIGCHLD",     "SIGCLD",     "SIGCONT",    "SIGFPE",   "SIGHUP",
    "SIGILL",      "SIGINT",       "SIGIO",     "SIGIOT",      "SIGKILL",    "SIGPIPE",    "SIGPOLL",  "SIGPROF",
    "SIGPWR",      "SIGQUIT",      "SIGRTMAX",  "SIGRTMIN",    "SIGSEGV",    "SIGSTKFLT",  "SIGSTKSZ", "SIGSTOP",
    "SIGSYS",      "SIGTERM",      "SIGTRAP",   "SIGTSTP",     "SIGTTIN",    "SIGTTOU",    "SIGURG",   "SIGUSR1",
    "SIGUSR2",     "SIGVTALRM",    "SIGWINCH",  "SIGXCPU",     "SIGXFSZ",    "SNAN",       "SNANF",    "SNANF128",
    "SNANF32",     "SNANF32X",     "SNANF64",   "SNANF64X",    "SNANL",      "WCONTINUED", "WEOF",     "WEXITED",
    "WEXITSTATUS", "WIFCONTINUED", "WIFEXITED", "WIFSIGNALED", "WIFSTOPPED", "WNOHANG",    "WNOWAIT",  "WSTOPPED",
    "WSTOPSIG",    "WTERMSIG",     "WUNTRACED"};

constexpr std::string_view other_macros[] = {"BUFSIZ",
                                             "CSIGNAL",
                                             "EOF",
                                             "INFINITY",
                                             "L_ctermid",
                                             "L_cuserid",
                                             "L_tmpnam",
                                             "MAXFLOAT",
                                             "MINSIGSTKSZ",
                                             "NAN",
                                             "NFDBITS",
                                             "NGREG",
                                             "NSIG",
                                             "NULL",
                                             "NZERO",
                                             "P_tmpdir",
                                             "alloca",
                                             "assert",
                                             "assert_perror",
                                             "be16toh",
                                             "be32toh",
                                             "be64toh",
                                             "ei_declare_aligned_stack_constructed_variable",
                                             "ei_declare_local_nested_eval",
                                             "eigen_assert",
                                             "eigen_internal_assert",
                                             "eigen_plain_assert",
                                             "errno",
                                             "htobe16",
                                             "htobe32",
                                             "htobe64",
                                             "htole16",
                                             "htole32",
                                             "htole64",
                                             "i386",
                                             "isascii",
                                             "issubnormal",
                                             "le16toh",
                                             "le32toh",
                                             "le64toh",
                                             "linux",
                                             "math_errhandling",
                                             "offsetof",
                                             "pthread_cleanup_pop",
                                             "pthread_cleanup_pop_restore_np",
                                             "pthread_cleanup_push",
                                             "pthread_cleanup_push_defer_np",
                                             "sa_handler",
                                             "sa_sigaction",
                                             "sched_priority",
                                             "setjmp",
                                             "si_addr",
                                             "si_addr_lsb",
                                             "si_arch",
                                             "si_band",
                                             "si_call_addr",
                                             "si_fd",
                                             "si_int",
                                             "si_lower",
                                             "si_overrun",
                                             "si_pid",
                                             "si_pkey",
                                             "si_ptr",
                                             "si_status",
                                             "si_stime",
                                             "si_syscall",
                                             "si_timerid",
                                             "si_uid",
                                             "si_upper",
                                             "si_utime",
                                             "si_value",
                                             "sigev_notify_attributes",
                                             "sigev_notify_function",
                                             "sigmask",
                                             "sigsetjmp",
                                             "stderr",
                                             "stdin",
                                             "stdout",
                                             "strdupa",
                                             "strndupa",
                                             "timeradd",
                                             "timerclear",
                                             "timercmp",
                                             "timerisset",
                                             "timersub",
                                             "toascii",
                                             "unix",
                                             "va_arg",
                                             "va_copy",
                                             "va_end",
                                             "va_start",
                                             "vec2d_duplane",
                                             "vec2d_swizzle1",
                                             "vec2d_swizzle2",
                                             "vec4f_duplane",
                                             "vec4f_swizzle1",
                                             "vec4f_swizzle2",
                                             "vec4i_swizzle1",
                                             "vec4i_swizzle2"};

// Functions, types and variables of C and POSIX outside all namespaces.
constexpr std::string_view library_names[] = {
    "abort",       "abs",        "access",    "acct",      "acos",        "acosh",      "alarm",         "alloca",
    "asctime",     "asin",       "asinh",     "atan",      "atan2",       "atanh",      "atexit",        "atof",
    "atoi",        "atol",       "atoll",     "bcmp",      "bcopy",       "bind",       "brk",           "bsearch",
    "bzero",       "calloc",     "cbrt",      "ceil",      "chdir",       "chmod",      "chown",         "chroot",
    "clearenv",    "clearerr",   "clock",     "clone",     "close",       "confstr",    "connect",       "copysign",
    "cos",         "cosh",       "creat",     "crypt",     "ctermid",     "ctime",      "cuserid",       "daemon",
    "daylight",    "difftime",   "div",       "dprintf",   "drand48",     "drem",       "dup",           "dysize",
    "ecvt",        "environ",    "erand48",   "erf",       "erfc",        "execl",      "execle",        "execlp",
    "execv",       "execve",     "execvp",    "exit",      "exp",         "exp10",      "exp2",          "expm1",
    "fabs",        "fadd",       "fchdir",    "fchmod",    "fchown",      "fclose",     "fcntl",         "fcvt",
    "fdatasync",   "fddiv",      "fdim",      "fdiv",      "fdopen",      "feof",       "ferror",        "fflush",
    "ffma",        "ffs",        "fgetc",     "fgetpos",   "fgets",       "fileno",     "finite",        "flock",
    "flockfile",   "floor",      "fma",       "fmax",      "fmemopen",    "fmin",       "fmod",          "fmul",
    "fopen",       "fork",       "fpathconf", "fprintf",   "fputc",       "fputs",      "fread",         "free",
    "freopen",     "frexp",      "fromfp",    "fromfpx",   "fscanf",      "fseek",      "fseeko",        "fsetpos",
    "fsqrt",       "fstat",      "fsub",      "fsync",     "ftell",       "ftello",     "ftime",         "ftruncate",
    "fwide",       "fwrite",     "gamma",     "gcvt",      "getc",        "getchar",    "getcpu",        "getcwd",
    "getdate",     "getdelim",   "getegid",   "getenv",    "geteuid",     "getgid",     "getgroups",     "gethostid",
    "gethostname", "getline",    "getlogin",  "getopt",    "getpass",     "getpayload", "getpgid",       "getpgrp",
    "getpid",      "getppid",    "getpt",     "getsid",    "gettid",      "getuid",     "getw",          "getwd",
    "gmtime",      "hypot",      "ilogb",     "index",     "initstate",   "ioctl",      "isalnum",       "isalpha",
    "isascii",     "isatty",     "isblank",   "iscntrl",   "isctype",     "isdigit",    "isgraph",       "islower",
    "isprint",     "ispunct",    "isspace",   "isupper",   "isxdigit",    "itimerspec", "itimerval",     "j0",
    "j1",          "jn",         "jrand48",   "kill",      "labs",        "lchown",     "lconv",         "ldexp",
    "ldiv",        "lgamma",     "link",      "listen",    "llabs",       "lldiv",      "llogb",         "llrint",
    "llround",     "localeconv", "localtime", "lockf",     "log",         "log10",      "log1p",         "log2",
    "logb",        "longjmp",    "lrand48",   "lrint",     "lround",      "lseek",      "lstat",         "malloc",
    "mblen",       "memccpy",    "memchr",    "memcmp",    "memcpy",      "memmem",     "memmove",       "memset",
    "mkdir",       "mkfifo",     "mknod",     "mkstemp",   "mktemp",      "mktime",     "mmap",          "modf",
    "mount",       "mrand48",    "nan",       "nanosleep", "nearbyint",   "nextafter",  "nextdown",      "nexttoward",
    "nextup",      "nice",       "nrand48",   "obstack",   "open",        "passwd",     "pathconf",      "pause",
    "pclose",      "perror",     "pipe",      "poll",      "popen",       "pow",        "pread",         "printf",
    "profil",      "psignal",    "ptsname",   "putc",      "putchar",     "putenv",     "puts",          "putw",
    "pwrite",      "qsort",      "raise",     "rand",      "random",      "read",       "readlink",      "readv",
    "realloc",     "realpath",   "recv",      "remainder", "remove",      "remquo",     "rename",        "revoke",
    "rewind",      "rindex",     "rint",      "rmdir",     "round",       "roundeven",  "rpmatch",       "rusage",
    "sbrk",        "scalb",      "scalbln",   "scalbn",    "scanf",       "seed48",     "select",        "send",
    "setbuf",      "setbuffer",  "setenv",    "setgid",    "setlocale",   "setpayload", "setsid",        "setstate",
    "setuid",      "setvbuf",    "shutdown",  "sigaction", "sigaltstack", "signal",     "signgam",       "significand",
    "sigstack",    "sin",        "sincos",    "sinh",      "sleep",       "snprintf",   "socket",        "sprintf",
    "sqrt",        "srand",      "srand48",   "srandom",   "sscanf",      "stat",       "statfs",        "stime",
    "stpcpy",      "strcat",     "strchr",    "strcmp",    "strcoll",     "strcpy",     "strcspn",       "strdup",
    "strerror",    "strfry",     "strftime",  "strlen",    "strncat",     "strncmp",    "strncpy",       "strpbrk",
    "strptime",    "strrchr",    "strsep",    "strspn",    "strstr",      "strtod",     "strtof",        "strtok",
    "strtol",      "strtold",    "strtoll",   "strtoul",   "strtoull",    "strxfrm",    "swab",          "symlink",
    "sync",        "syscall",    "sysconf",   "system",    "tan",         "tanh",       "tempnam",       "tgamma",
    "time",        "timegm",     "timelocal", "times",     "timespec",    "timeval",    "timex",         "timezone",
    "tm",          "tmpfile",    "tmpnam",    "tms",       "tolower",     "totalorder", "totalordermag", "toupper",
    "trunc",       "truncate",   "ttyname",   "ttyslot",   "tzname",      "tzset",      "ualarm",        "ufromfp",
    "ufromfpx",    "ulimit",     "umask",     "umount",    "uname",       "ungetc",     "unlink",        "unlockpt",
    "unsetenv",    "unshare",    "usleep",    "ustat",     "utime",       "utsname",    "valloc",        "vfork",
    "vhangup",     "vprintf",    "vscanf",    "vsprintf",  "wait",        "waitpid",    "winsize",       "write",
    "writev",      "y0",         "y1",        "yn"};

bool is_capital_or_digit(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0 || (c >= '0' && c <= '9'); }

// "M_PIf" behind "M_", "cudaHostAllocMapped" behind "cuda".
bool goes_on_in_capitals(std::string_view name, std::string_view beginning) {
  return name.size() > beginning.size() && name.starts_with(beginning) && is_capital_or_digit(name[beginning.size()]);
}

}  // namespace

bool is_written_as_a_macro(std::string_view name) {
  return name.find('_') != std::string_view::npos &&
         std::all_of(name.begin(), name.end(), [](char c) { return c == '_' || is_capital_or_digit(c); });
}

bool is_macro(std::string_view name) {
  for (const char* beginning : {"M_", "cuda", "cu"})
    if (goes_on_in_capitals(name, beginning)) return true;
  for (const char* beginning : {"PHYSGEN", "EIGEN_", "SYS_"})
    if (name.starts_with(beginning)) return true;
  // From <cinttypes>: PRIu64, SCNxMAX.
  if ((name.starts_with("PRI") || name.starts_with("SCN")) && name.size() > 4 &&
      std::string_view("diouxX").find(name[3]) != std::string_view::npos && is_capital_or_digit(name[4]))
    return true;
  return is_one_of(name, error_numbers) || is_one_of(name, signals_and_states) || is_one_of(name, other_macros);
}

bool is_name_of_the_c_library(std::string_view name) {
  if (is_one_of(name, library_names) || name.ends_with("_t")) return true;
  // sinf, sinl: the mathematical functions for float and long double.
  return name.size() > 2 && (name.back() == 'f' || name.back() == 'l') &&
         is_one_of(name.substr(0, name.size() - 1), library_names);
}

}  // namespace physgen::emit::cpp
