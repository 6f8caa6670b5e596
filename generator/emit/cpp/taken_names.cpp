// See taken_names.h: the words of C++, and names of the C library.
#include "emit/cpp/taken_names.h"

namespace physgen::emit::cpp {
namespace {

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

}  // namespace

bool is_word_of_the_language(std::string_view name) {
  constexpr std::string_view words[] = {"and", "and_eq", "bitand", "bitor", "char8_t", "compl",
                                        "not", "not_eq", "or",     "or_eq", "xor",     "xor_eq"};
  return is_one_of(name, words);
}

bool is_name_of_the_c_library(std::string_view name) {
  if (is_one_of(name, library_names) || name.ends_with("_t")) return true;
  // sinf, sinl: the mathematical functions for float and long double.
  return name.size() > 2 && (name.back() == 'f' || name.back() == 'l') &&
         is_one_of(name.substr(0, name.size() - 1), library_names);
}

}  // namespace physgen::emit::cpp
