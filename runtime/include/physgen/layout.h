// All layouts. Each of them obeys the law of addresses (layout/address.h) and is stated by one number, its pitch.
#pragma once

#include <physgen/layout/aos.h>
#include <physgen/layout/aos_padded.h>
#include <physgen/layout/aosoa.h>
#include <physgen/layout/soa.h>
