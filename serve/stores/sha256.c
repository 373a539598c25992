/* sha256.c - SHA-256 with the symbols of FIPS 180-4: Sigma, sigma, Ch, Maj. */
#include "serve/stores/sha256.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

static const uint32_t K[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4,
    0xab1c5ed5, 0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe,
    0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f,
    0x4a7484aa, 0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7,
    0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc,
    0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85, 0xa2bfe8a1, 0xa81a664b,
    0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116,
    0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7,
    0xc67178f2};

static uint32_t turned(uint32_t x, int by)
{
    return x >> by | x << (32 - by);
}

static void add_block(uint32_t H[8], const unsigned char block[64])
{
    uint32_t W[64], v[8];
    for (int t = 0; t < 16; t++)
        W[t] = (uint32_t)block[4 * t] << 24 | (uint32_t)block[4 * t + 1] << 16
               | (uint32_t)block[4 * t + 2] << 8 | block[4 * t + 3];
    for (int t = 16; t < 64; t++) {
        uint32_t a = W[t - 15], b = W[t - 2];
        uint32_t sigma0 = turned(a, 7) ^ turned(a, 18) ^ a >> 3;
        uint32_t sigma1 = turned(b, 17) ^ turned(b, 19) ^ b >> 10;
        W[t] = W[t - 16] + sigma0 + W[t - 7] + sigma1;
    }
    memcpy(v, H, sizeof v);
    for (int t = 0; t < 64; t++) {
        uint32_t a = v[0], e = v[4];
        uint32_t Sigma1 = turned(e, 6) ^ turned(e, 11) ^ turned(e, 25);
        uint32_t Sigma0 = turned(a, 2) ^ turned(a, 13) ^ turned(a, 22);
        uint32_t Ch = (e & v[5]) ^ (~e & v[6]);
        uint32_t Maj = (a & v[1]) ^ (a & v[2]) ^ (v[1] & v[2]);
        uint32_t T1 = v[7] + Sigma1 + Ch + K[t] + W[t], T2 = Sigma0 + Maj;
        memmove(v + 1, v, 7 * sizeof *v);
        v[4] += T1;
        v[0] = T1 + T2;
    }
    for (int i = 0; i < 8; i++)
        H[i] += v[i];
}

void pp_sha256_hex(char hex[65], const char *bytes, size_t length)
{
    uint32_t H[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                     0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    unsigned char block[64];
    size_t whole = length / 64, rest = length % 64;
    for (size_t i = 0; i < whole; i++)
        add_block(H, (const unsigned char *)bytes + 64 * i);
    memset(block, 0, sizeof block);
    memcpy(block, bytes + 64 * whole, rest);
    block[rest] = 0x80;
    if (rest >= 56) {
        add_block(H, block);
        memset(block, 0, sizeof block);
    }
    uint64_t bits = (uint64_t)length * 8;
    for (int i = 0; i < 8; i++)
        block[63 - i] = (unsigned char)(bits >> 8 * i);
    add_block(H, block);
    for (int i = 0; i < 8; i++)
        snprintf(hex + 8 * i, 9, "%08x", H[i]);
}
