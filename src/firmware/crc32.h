/* zlib's CRC-32, for what was sent to a panel. */
#ifndef FIXCAST_FIRMWARE_CRC32_H
#define FIXCAST_FIRMWARE_CRC32_H

#include <stddef.h>
#include <stdint.h>

/* The CRC of bytes that follow those of `crc`; 0 to begin with. */
uint32_t fc_crc32(uint32_t crc, const uint8_t *bytes, size_t count);

/* The CRC of some bytes followed by `count` others, from the CRCs of the two. */
uint32_t fc_crc32_join(uint32_t crc, uint32_t crc_of_others, uint32_t count);

#endif
