// Entry point: reads the data of the page and shows it.

import 'uplot/dist/uPlot.min.css';
import './style/base.css';
import './style/head.css';
import './style/replay.css';
import './style/time.css';
import './style/plots.css';
import './style/robot.css';
import './style/help.css';
import './style/small.css';
import { decodePage } from './data';
import { h } from './dom';
import { robotPage } from './robot_page';
import { runPage } from './run_page';

export interface BurnishApi {
  ready: boolean;
  readonly time: number;
  readonly playing: boolean;
  readonly renderCount: number;
  /** First and last time of the plots [s] */
  readonly window: [number, number];
  runs: number;
  plots: string[];
  setTime(time: number): void;
  play(): void;
  pause(): void;
  /** Value of a column of a run at the time cursor; on the page of a robot, value of a joint */
  value(name: string, run?: number): number;
  /** Position of the tool frame of the drawn robot in the world [m]; null without a tool frame */
  drawnTool(): [number, number, number] | null;
}

declare global {
  interface Window {
    burnish?: BurnishApi;
  }
}

function show(host: HTMLElement): void {
  const page = decodePage(document.getElementById('burnish-data')?.textContent ?? 'null');
  if (!page) {
    host.replaceChildren(
      h(
        'p',
        { class: 'empty' },
        'This page contains no run. burnish writes a copy of this page with the data of a run.',
      ),
    );
    return;
  }
  document.title = `${page.title} · burnish`;
  if (page.kind === 'robot' && page.robot) robotPage(page, page.robot, host);
  else if (page.runs.length > 0) runPage(page, host);
  else throw new Error('it contains neither a run nor a robot');
}

const host = document.getElementById('app')!;
try {
  show(host);
} catch (error) {
  const text = error instanceof Error ? error.message : String(error);
  host.replaceChildren(
    h('p', { class: 'empty', role: 'alert' }, `This page cannot be shown: ${text}.`),
  );
  throw error;
}
