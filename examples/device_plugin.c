/* A plug-in for percuss record: a generator of a sine and a counter, with the faults that a device can have.
 *
 *   cc -shared -fPIC -I include examples/device_plugin.c -o device.so -lm
 *   percuss record --device plugin:./device.so:channels=2,seconds=10 …
 *
 * Arguments, separated by commas: channels=N, seconds=S (then it finishes), lose=FRAME (64 frames are lost there),
 * unplug (after its last frame it reports that it was unplugged). A driver of real hardware replaces generate(). */
#include <math.h>
#include <percuss/device_plugin.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LOST_FRAMES = 64, MAX_CHANNELS = 16 };

struct percuss_device {
  percuss_device_format format;
  const char* units[MAX_CHANNELS];
  uint64_t frame;       /* the next one */
  uint64_t frame_count; /* of the session */
  uint64_t lose_at;     /* 0: nowhere */
  uint32_t end_flag;    /* of the last block */
};

static percuss_device* refuse(percuss_device* device, const char* why, char* error, size_t error_bytes) {
  snprintf(error, error_bytes, "%s", why);
  free(device);
  return NULL;
}

static percuss_device* open_device(const char* arguments, double fs_hz, char* error, size_t error_bytes) {
  percuss_device* device = calloc(1, sizeof *device);
  if (device == NULL) return refuse(device, "no memory", error, error_bytes);
  unsigned channels = 2;
  double seconds = 1;
  const double rate = fs_hz > 0 ? fs_hz : 48000;
  device->end_flag = PERCUSS_BLOCK_FINISHED;
  for (const char* at = arguments; *at != '\0';) {
    unsigned long long lose_at = 0;
    if (sscanf(at, "channels=%u", &channels) == 1 || sscanf(at, "seconds=%lf", &seconds) == 1) {
    } else if (sscanf(at, "lose=%llu", &lose_at) == 1) {
      device->lose_at = lose_at;
    } else if (strncmp(at, "unplug", 6) == 0) {
      device->end_flag = PERCUSS_BLOCK_UNPLUGGED;
    } else {
      return refuse(device, "an argument is unknown", error, error_bytes);
    }
    at += strcspn(at, ",");
    if (*at == ',') ++at;
  }
  if (channels < 1 || channels > MAX_CHANNELS || !(seconds > 0 && seconds < 1e6))
    return refuse(device, "an argument is out of range", error, error_bytes);
  for (unsigned c = 0; c < channels; ++c) device->units[c] = c == 0 ? "V" : "";
  device->frame_count = (uint64_t)(seconds * rate);
  device->format = (percuss_device_format){
      .size = sizeof device->format,
      .channels = channels,
      .fs_hz = rate,
      .sample_type = PERCUSS_SAMPLE_FLOAT32,
      .waits = 1, /* it has no clock of its own; a driver of hardware says 0 */
      .scale = 1,
      .full_scale = 10,
      .name = "example generator",
      .units = device->units,
  };
  return device;
}

static const percuss_device_format* format_of(percuss_device* device) { return &device->format; }

static int start(percuss_device* device, char* error, size_t error_bytes) {
  (void)error;
  (void)error_bytes;
  device->frame = 0;
  return 0;
}

/* Channel 1: a sine of 100 Hz and 1 V. The others: the number of the frame. */
static void generate(const percuss_device* device, float* frames, uint32_t count) {
  const uint32_t channels = device->format.channels;
  for (uint32_t i = 0; i < count; ++i) {
    const uint64_t frame = device->frame + i;
    frames[i * channels] = (float)sin(2 * 3.14159265358979323846 * 100 * (double)frame / device->format.fs_hz);
    for (uint32_t c = 1; c < channels; ++c) frames[i * channels + c] = (float)(frame % 16777216);
  }
}

static void read_frames(percuss_device* device, void* frames, uint32_t capacity, uint32_t timeout_ms,
                        percuss_device_block* block) {
  (void)timeout_ms; /* its frames are always there */
  uint64_t until = device->frame_count;
  if (device->lose_at > 0 && device->frame == device->lose_at) {
    device->frame += LOST_FRAMES;
    block->flags = PERCUSS_BLOCK_OVERRUN;
    return; /* the next block states how many frames were lost */
  } else if (device->frame < device->lose_at && device->lose_at < until) {
    until = device->lose_at;
  }
  const uint64_t left = until > device->frame ? until - device->frame : 0;
  const uint32_t count = left < capacity ? (uint32_t)left : capacity;
  generate(device, frames, count);
  block->first_frame = device->frame;
  block->frames = count;
  device->frame += count;
  if (device->frame >= device->frame_count) block->flags |= device->end_flag;
}

static void stop(percuss_device* device) { (void)device; }

static void close_device(percuss_device* device) { free(device); }

static const percuss_device_plugin kPlugin = {
    .size = sizeof(percuss_device_plugin),
    .open = open_device,
    .format = format_of,
    .start = start,
    .read = read_frames,
    .stop = stop,
    .close = close_device,
};

#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const percuss_device_plugin*
percuss_device_plugin_v1(void);

const percuss_device_plugin* percuss_device_plugin_v1(void) { return &kPlugin; }
