// One clock for all that moves: time within the breath, playing or not.

const still = matchMedia('(prefers-reduced-motion: reduce)');

export class Clock {
  constructor(duration, frame) {
    this.duration = duration;
    this.frame = frame; // s between stored frames: what the arrow keys step
    this.time = 0;
    this.speed = 1;
    this.playing = false;
    this.listeners = [];
    this.states = [];
  }

  onTime(listener) {
    this.listeners.push(listener);
  }

  onState(listener) {
    this.states.push(listener);
  }

  seek(time) {
    this.time = Math.min(Math.max(time, 0), this.duration);
    for (const listener of this.listeners) listener(this.time);
  }

  step(frames) {
    this.pause();
    this.seek((Math.round(this.time / this.frame) + frames) * this.frame);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.duration <= 0) return;
    this.playing = true;
    let before = null;
    const tick = (now) => {
      if (!this.playing) return;
      if (before !== null) {
        const next = this.time + (this.speed * (now - before)) / 1000;
        this.seek(next > this.duration ? next % this.duration : next);
      }
      before = now;
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
    this.tell();
  }

  pause() {
    this.playing = false;
    this.tell();
  }

  tell() {
    for (const listener of this.states) listener(this.playing);
  }
}

export const defaultSpeed = () => (still.matches ? 0.25 : 1);
