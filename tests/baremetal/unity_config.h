/* unity.h (ours or the real one) on an emulated chip: -DUNITY_INCLUDE_CONFIG_H. */
#include "semihost.h"

#define UNITY_SUPPORT_64
#define UNITY_OUTPUT_CHAR(c) semihost_char(c)
#define UNITY_OUTPUT_FLUSH() semihost_flush()
