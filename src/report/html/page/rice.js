// Decodes the sequences of a Rice code (src/report/json/rice_code.hpp), one per call: reader(count).
const riceReader = (text) => {
  const bytes = atob(text);
  let at = 0;
  const bit = () => {
    const value = (bytes.charCodeAt(at >> 3) >> (7 - (at & 7))) & 1;
    ++at;
    return value;
  };
  const number = (bits) => {
    let value = 0;
    for (; bits > 0; --bits) value = 2 * value + bit();
    return value;
  };
  return (count) => {
    const k = number(4), out = new Array(count);
    let value = 0;
    for (let i = 0; i < count; ++i) {
      let ones = 0;
      while (ones < 20 && bit()) ++ones;
      const z = ones < 20 ? ones * 2 ** k + number(k) : number(24);
      value += z % 2 ? -(z + 1) / 2 : z / 2;
      out[i] = value;
    }
    return out;
  };
};
