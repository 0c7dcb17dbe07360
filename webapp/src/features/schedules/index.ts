export { useReserveBuild } from './queries';
export { ScheduleList } from './ScheduleList';
