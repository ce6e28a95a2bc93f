/* The interface between percuss and a plug-in that delivers the samples of a recording device.
 *
 * A plug-in is a shared library in C, or in any language that can export C functions. It exports one function,
 *     const percuss_device_plugin* percuss_device_plugin_v1(void);
 * which returns a table of functions. percuss opens it by `--device plugin:PATH[:ARGUMENTS]`. examples/device_plugin.c
 * is a whole plug-in; docs/guides/device-plugin.md explains how to write one.
 *
 * The calls come from one thread at a time: open, format, start, read …, stop, close. read may block for the stated
 * time; everything else returns soon. A plug-in keeps no pointer that percuss passes. Memory that it returns stays
 * valid until close. Later versions of this header only add members: the size of a structure tells which it has.
 */
#ifndef PERCUSS_DEVICE_PLUGIN_H
#define PERCUSS_DEVICE_PLUGIN_H
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers of a frame, in the byte order of the machine. */
enum { PERCUSS_SAMPLE_INT32 = 1, PERCUSS_SAMPLE_FLOAT32 = 2, PERCUSS_SAMPLE_FLOAT64 = 3 };

/* Flags of a block. */
enum {
  PERCUSS_BLOCK_OVERRUN = 1,      /* the device lost frames before this block; first_frame tells how many, if known */
  PERCUSS_BLOCK_FINISHED = 2,     /* no frame will follow */
  PERCUSS_BLOCK_UNPLUGGED = 4,    /* no frame will follow: the device is gone */
  PERCUSS_BLOCK_RATE_CHANGED = 8, /* no frame will follow: its sampling rate changed */
  PERCUSS_BLOCK_FAILED = 16       /* no frame will follow: it failed */
};

typedef struct percuss_device percuss_device; /* the plug-in's own */

typedef struct percuss_device_format {
  uint32_t size;                    /* sizeof(percuss_device_format) */
  uint32_t channels;                /* 1 … 4096 */
  double fs_hz;                     /* samples per second and channel */
  uint32_t sample_type;             /* PERCUSS_SAMPLE_… */
  uint32_t waits;                   /* 1: the device may wait for read without losing frames (a replay) */
  double scale;                     /* value in the stated unit = number × scale */
  double full_scale;                /* the largest |value|; 0: not known */
  const char* name;                 /* for people */
  const char* const* channel_names; /* [channels], or NULL */
  const char* const* units;         /* [channels]: "V", "N", "m/s^2", ""; or NULL */
} percuss_device_format;

typedef struct percuss_device_block {
  uint32_t size;        /* percuss sets sizeof(percuss_device_block) before read, and the other members to 0 */
  uint32_t flags;       /* PERCUSS_BLOCK_… */
  uint64_t first_frame; /* frames since start, lost ones included: a jump is a loss */
  uint32_t frames;      /* delivered; 0: none came in time */
} percuss_device_block;

typedef struct percuss_device_plugin {
  uint32_t size; /* sizeof(percuss_device_plugin) */
  /* Opens a device. `arguments` is what the user wrote after the path, or "". `fs_hz` is the rate wanted, or 0. Returns
   * NULL after a failure, with one line of text in `error`. */
  percuss_device* (*open)(const char* arguments, double fs_hz, char* error, size_t error_bytes);
  const percuss_device_format* (*format)(percuss_device* device);
  /* Starts the frames. Returns 0; any other number is a failure, with one line of text in `error`. */
  int (*start)(percuss_device* device, char* error, size_t error_bytes);
  /* Waits up to `timeout_ms` for frames and copies at most `capacity` of them, channels interleaved, to `frames`.
   * Describes them in `block`. */
  void (*read)(percuss_device* device, void* frames, uint32_t capacity, uint32_t timeout_ms,
               percuss_device_block* block);
  void (*stop)(percuss_device* device);
  void (*close)(percuss_device* device);
} percuss_device_plugin;

typedef const percuss_device_plugin* (*percuss_device_plugin_function)(void);
#define PERCUSS_DEVICE_PLUGIN_SYMBOL "percuss_device_plugin_v1"

#ifdef __cplusplus
}
#endif
#endif
